#!/usr/bin/env bats
# ParaView opens what to-vtk writes, finds in it what the HDF5 file says, and show.py makes a picture of it. Run where there is a
# pvpython: PARAVIEW, one unpacked by `make paraview`, or one on PATH.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup_file() {
  load common
  [ -z "${NO_VTK:-}" ] || return 0
  local unpacked=${BATS_TEST_DIRNAME%/tests/tools}/build/paraview/pvpython
  [ -n "${PARAVIEW:-}" ] || [ ! -x "$unpacked" ] || PARAVIEW=$unpacked
  export PARAVIEW=${PARAVIEW:-$(command -v pvpython)}
  [ -n "$PARAVIEW" ] || return 0
  cd "$BATS_FILE_TMPDIR" || return
  # Debian's ParaView draws with X only. A server that resets itself after its last client would refuse it. bats waits until its
  # descriptor 3 is closed.
  if [ -z "${DISPLAY:-}" ] && command -v Xvfb > /dev/null; then
    Xvfb -noreset -displayfd 7 -screen 0 1600x1200x24 7> display 2> xvfb.log 3>&- &
    echo $! > xvfb.pid
    for _ in $(seq 100); do [ ! -s display ] || break; sleep 0.1; done
    DISPLAY=:$(cat display)
  fi
  export DISPLAY=${DISPLAY:-}
  make_runs
}

teardown_file() {
  [ ! -e "$BATS_FILE_TMPDIR/xvfb.pid" ] || kill "$(cat "$BATS_FILE_TMPDIR/xvfb.pid")"
}

# The inputs are a pressed bag, three of whose yarns are marked broken, its packing, and a pull-out.
make_runs() {
  pack-generate --quiet --grains 300 --void-ratio 0.72 --pressure 1e4 --tolerance 1e-2 -o packing.h5
  filter-expand --quiet packing.h5 "$BATS_TEST_DIRNAME/examples/bag.toml" -o bag.h5
  run-dem --quiet bag.h5 "$BATS_TEST_DIRNAME/examples/press.toml" -o run.h5
  "$PYTHON" - << 'PY'
import h5py
with h5py.File("run.h5", "r+") as file:
    yarns = file["yarns"]
    last = yarns["tension"].shape[0] - 1
    for yarn in (0, 150, 311):
        ends = file["particles/grains/position/value"][last][yarns["nodes"][last, yarn]]
        yarns["broken"][last, yarn], yarns["tension"][last, yarn] = 1, 0
        yarns["break_time"][last, yarn] = file["particles/grains/position/time"][last]
        yarns["break_position"][last, yarn] = ends.mean(axis=0)
PY
  homogenize --quiet --grains --yarns run.h5 -o fields.h5
  fabric --quiet run.h5 -o fabric.h5
  fem-dem --quiet "$BATS_TEST_DIRNAME/examples/pull.toml" -o pull.h5
}

setup() {
  [ -z "${NO_VTK:-}" ] || skip "built without VTK"
  [ -n "$PARAVIEW" ] || skip "no ParaView: make paraview unpacks one, or set PARAVIEW"
  [ -n "$DISPLAY" ] || skip "no display for ParaView: apt-get install xvfb"
  cd "$BATS_TEST_TMPDIR" || return
  ln -s "$BATS_FILE_TMPDIR"/*.h5 .
}

check() {
  local interpreter=$PYTHON
  [[ $1 != open ]] || interpreter=$PARAVIEW
  "$interpreter" "$BATS_TEST_DIRNAME/paraview_check.py" "$@"
}

@test "a bag with strains: every group opens and is what the run says; grains, chains, yarns, breaks, the cut are seen" {
  to-vtk --quiet run.h5 --fields fields.h5 -o out
  check expect run.h5 --fields fields.h5 > expected.json
  check open out expected.json
  "$PARAVIEW" out/show.py picture.png
  check look picture.png 2,2 --red 2
}

@test "what is missing is found" {
  to-vtk --quiet run.h5 --fields fields.h5 -o out
  check expect run.h5 --fields fields.h5 > expected.json
  local file name last
  for file in yarns:tension contacts:normal_force grains:strain_deviatoric broken:break_time; do
    cp -r out faulty
    name=${file#*:}
    # Another name of equal length keeps the offsets of the appended data right.
    sed -i "s/Name=\"$name\"/Name=\"${name//?/x}\"/" "faulty/${file%:*}"_*.vtp
    run ! check open faulty expected.json
    [[ $output == *"no array $name"* ]] || show
    rm -r faulty
  done
  cp -r out faulty
  last=(faulty/yarns_*.vtp)
  cp out/yarns_000000.vtp "${last[-1]}"
  run ! check open faulty expected.json
  [[ $output == *"yarns, state"* ]] || show
  rm faulty/planes.pvd
  run ! check open faulty expected.json
  [[ $output == *"were written, not"* ]] || show
  # A panel with outlines alone.
  mkdir empty
  cp out/cell* out/planes* out/show.py empty
  sed -i 's/^    if not panels:/    panel(outlines=outlines)\n&/' empty/show.py
  "$PARAVIEW" empty/show.py picture.png
  run ! check look picture.png 1
  [[ $output == *"panel 0 shows nothing"* ]] || show
}

@test "a packing in a periodic cell" {
  to-vtk --quiet packing.h5 -o out
  check expect packing.h5 > expected.json
  check open out expected.json
  # ParaView's window runs the script without telling it its path.
  "$PARAVIEW" -c 'import sys; exec(open(sys.argv[1]).read(), {"__name__": "__main__"})' out/show.py picture.png
  check look picture.png 2
}

@test "fields: yarns and grains with their numbers, tables" {
  to-vtk --quiet fields.h5 -o out
  check expect fields.h5 > expected.json
  check open out expected.json
  "$PARAVIEW" out/show.py picture.png
  check look picture.png 2,1 --red 1
  to-vtk --quiet fabric.h5 -o tables
  check open tables <(echo '{}')
}

@test "two scales: the mesh by what its points bear, the geosynthetic by tension" {
  to-vtk --quiet pull.h5 -o out
  check expect pull.h5 > expected.json
  check open out expected.json
  "$PARAVIEW" out/show.py picture.png
  check look picture.png 3,2
}
