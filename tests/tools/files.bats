#!/usr/bin/env bats
# The files tools exchange: other programs open them, pipes carry them, damage is reported, histories reach their origin.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup_file() {
  load common
  cd "$BATS_FILE_TMPDIR" || return
  cat "$BATS_TEST_DIRNAME/sand.toml" - > short.toml << 'TOML'
[[stage]]
path = "triaxial"
confining_pressure = "100 kPa"
axial_strain = 0.001
increment = 0.0005
rate = 0.5
TOML
  pack-generate --quiet --grains 120 --aspect 1 --void-ratio 0.7 --pressure 1e5 -o packing.h5
  pack-generate --quiet --grains 60 --dimension 2 --void-ratio 0.12 --pressure 1e5 -o disks.h5
  pack-generate --quiet --import "$BATS_TEST_DIRNAME/examples/spheres.txt" --as-is -o imported.h5
  run-dem --quiet packing.h5 short.toml -o run.h5
  homogenize --quiet run.h5 --grains -o fields.h5
  fabric --quiet run.h5 -o fabric.h5
}

setup() {
  cd "$BATS_FILE_TMPDIR" || return
}

every_file() {
  echo packing.h5 disks.h5 imported.h5 run.h5 fields.h5 fabric.h5
}

@test "H5MD 1.1 and its units; every dataset reads and says its units and long_name" {
  "$PYTHON" -c 'import h5py' || skip "no Python with h5py"
  # shellcheck disable=SC2046  # one word a file
  run "$PYTHON" "$BATS_TEST_DIRNAME/h5md_conformance.py" $(every_file)
  [[ $status -eq 0 ]] || show "not conforming"
}

@test "h5dump reads every byte of them" {
  command -v h5dump > /dev/null || skip "no h5dump"
  local file
  for file in $(every_file); do
    exits 0 h5dump "$file"
    [[ -z $stderr ]] || show "h5dump $file"
  done
}

@test "no time stamps: the same call gives the same bytes a second later" {
  sleep 1.1
  pack-generate --quiet --grains 120 --aspect 1 --void-ratio 0.7 --pressure 1e5 -o "$BATS_TEST_TMPDIR/again.h5"
  same_bytes packing.h5 "$BATS_TEST_TMPDIR/again.h5"
}

@test "a pipe carries the same bytes as a file" {
  pack-generate --quiet --grains 120 --aspect 1 --void-ratio 0.7 --pressure 1e5 -o - > "$BATS_TEST_TMPDIR/piped.h5"
  same_bytes packing.h5 "$BATS_TEST_TMPDIR/piped.h5"
  run-dem --quiet - short.toml -o - < packing.h5 > "$BATS_TEST_TMPDIR/run.h5"
  same_bytes run.h5 "$BATS_TEST_TMPDIR/run.h5"
}

@test "every chain of records reaches pack-generate" {
  command -v to-vtk > /dev/null || skip "to-vtk is not built (NO_VTK)"
  local file
  for file in $(every_file); do
    exits 0 to-vtk --history "$file"
    [[ $output == *"0. pack-generate "* ]] || show "$file does not reach pack-generate"
  done
  [[ $(to-vtk --history fields.h5 | grep -c '^[0-9]') -eq 3 ]]
  # The chain has the digest of the file.
  to-vtk --history run.h5 | grep -q "made by 0, sha256 $(sha256sum packing.h5 | cut -d ' ' -f 1)"
}

@test "a file that is missing, a folder, text, empty, cut short or damaged is told in one line" {
  local cut=$BATS_TEST_TMPDIR/cut.h5
  mentions 66 homogenize "no such file" none.h5 --tsv
  mentions 65 homogenize "directory; name a file in" . --tsv
  mentions 65 homogenize "short.toml: not an HDF5 file" short.toml --tsv
  mentions 65 homogenize "/dev/null: empty" /dev/null --tsv
  head -c 3000 packing.h5 > "$cut"
  mentions 65 homogenize "truncated: 3000 bytes of $(stat -c %s packing.h5)" "$cut" --tsv
  mentions 65 homogenize "fields.h5: holds fields, but packing or run is needed here" fields.h5 --tsv
}

@test "what h5py changed is read, or refused with the path" {
  "$PYTHON" -c 'import h5py' || skip "no Python with h5py"
  local edited=$BATS_TEST_TMPDIR/edited.h5
  edit() {
    cp packing.h5 "$edited"
    "$PYTHON" -c "import h5py; f = h5py.File('$edited', 'r+'); g = f['particles/grains']; $1"
  }
  edit 'f.attrs["note"] = "mine"'
  exits 0 homogenize "$edited" --tsv
  edit 'f.attrs["format_version"] = [2, 1]'
  mentions 65 homogenize "has the format version 2.1, this program reads 1.3 at most" "$edited" --tsv
  edit 'del g["mass"]'
  mentions 65 homogenize "/particles/grains/mass is missing" "$edited" --tsv
  edit 'g["position/value"][0, 5, 1] = float("nan")'
  mentions 65 homogenize "/particles/grains/position/value holds nan as value 16 of 360" "$edited" --tsv
  edit 'v = g["radius"][:-1]; del g["radius"]; g["radius"] = v'
  mentions 65 homogenize "/particles/grains/radius has the shape 119 where 120 belongs" "$edited" --tsv
  edit 'del f["contacts/000000/overlap"]; f["contacts/000000/overlap"] = "word"'
  mentions 65 homogenize "/contacts/000000/overlap" "$edited" --tsv
}

@test "what lies outside a file, or was never written, is refused by name and at once; links within it are followed" {
  "$PYTHON" -c 'import h5py' || skip "no Python with h5py"
  cd "$BATS_TEST_TMPDIR"
  local made=$BATS_FILE_TMPDIR
  mkfifo pipe
  edit() {
    cp "$made/packing.h5" edited.h5
    "$PYTHON" -c "import h5py; f = h5py.File('edited.h5', 'r+'); g = f['particles/grains']; v = g['mass'][:]; n = len(v); $1"
  }
  refused() {
    edit "$2"
    (ulimit -v 2000000 && timeout 10 homogenize edited.h5 --tsv > table 2> said) && show "taken: $2"
    [[ $(wc -l < said) -eq 1 && $(< said) == *"$1"* ]] || show "$2: $(< said)"
  }
  refused "mass is a link into another file (pipe)" "del g['mass']; g['mass'] = h5py.ExternalLink('pipe', '/x')"
  refused "/contacts is a link into another file" "del f['contacts']; f['contacts'] = h5py.ExternalLink('pipe', '/x')"
  refused "/e is a link into another file" "f['e'] = h5py.ExternalLink('pipe', '/'); del g['mass']; g['mass'] = h5py.SoftLink('/e/x')"
  refused "keeps its values in another file (pipe)" "del g['mass']; g.create_dataset('mass', (n,), 'f8', external=[('pipe', 0, 8 * n)])"
  refused "a virtual dataset" "del g['mass']; l = h5py.VirtualLayout((n,), 'f8'); \
l[:] = h5py.VirtualSource('pipe', 'x', shape=(n,)); g.create_virtual_dataset('mass', l)"
  refused "filter 32000 (lzf), which this machine lacks" "del g['mass']; g.create_dataset('mass', data=v, compression='lzf')"
  refused "was never written" "del g['mass']; g.create_dataset('mass', (n,), 'f8')"
  refused "lacks 11 of its 12 chunks" "del g['mass']; g.create_dataset('mass', (n,), 'f8', chunks=(10,))[:10] = v[:10]"
  refused "more than a file of" "del g['mass']; g.create_dataset('mass', (n,), 'f8', chunks=(2**28 - 1,), maxshape=(None,), compression='gzip')"
  refused "more than a file of" "del g['position/value']; g['position'].create_dataset('value', (1, 20000000, 3), 'f8', chunks=(1, 65536, 3), compression='gzip')"
  refused 'is in the unit "mm"; m is read here' "g['radius'].attrs['unit'] = 'mm'"
  refused 'boundary of "open"' "g['box'].attrs['boundary'] = ['open', 'periodic', 'periodic']"
  refused 'is missing' "del g['mass']; g['mass'] = h5py.SoftLink('/particles/grains/mass')"
  edit "f.move('particles/grains/mass', 'far'); g['mass'] = h5py.SoftLink('/far'); f.move('particles/grains/radius', 'particles/grains/r'); g['radius'] = h5py.SoftLink('r')"
  exits 0 homogenize edited.h5 --tsv
  # The file is open for writing elsewhere: it is not damaged, and the remedy works.
  cp "$made/packing.h5" edited.h5
  "$PYTHON" -c "import h5py, os; f = h5py.File('edited.h5', 'r+', libver='latest'); f.attrs['x'] = 1; f.flush(); os._exit(0)"
  mentions 65 homogenize "is open for writing in another program" edited.h5 --tsv
  h5clear -s edited.h5
  exits 0 homogenize edited.h5 --tsv
}

@test "a history cannot steer the terminal" {
  "$PYTHON" -c 'import h5py' || skip "no Python with h5py"
  cp packing.h5 "$BATS_TEST_TMPDIR/words.h5"
  "$PYTHON" -c "import h5py; h5py.File('$BATS_TEST_TMPDIR/words.h5', 'r+')['provenance/000000'].attrs['command'] = 'a\x1b[2J\nb\u202e'"
  exits 0 to-vtk --history "$BATS_TEST_TMPDIR/words.h5"
  [[ $output == *'command: a\x1b[2J\nb\u{202e}'* ]] || show "not written out"
}

@test "files of runs open in MDAnalysis" {
  "$PYTHON" -W ignore -c 'import MDAnalysis' || skip "no Python with MDAnalysis"
  "$PYTHON" -W ignore -c '
import h5py, MDAnalysis
file = h5py.File("run.h5"); grains = file["particles/grains"]
u = MDAnalysis.Universe.empty(grains["position/value"].shape[1], trajectory=True)
u.load_new("run.h5", format="H5MD", convert_units=False)
series = dict(zip(file["series/step"][:], file["series/void_ratio"][:]))
assert u.trajectory.n_frames == grains["position/value"].shape[0] and u.trajectory.units["time"] == "s"
assert all(ts.data["void_ratio"] == series[ts.data["step"]] for ts in u.trajectory)'
}

@test "a standard error that is gone, and closed streams, change neither status nor bytes" {
  local run=$BATS_TEST_TMPDIR/run.h5 status=0
  run-dem packing.h5 short.toml -o "$run" 2> /dev/full
  same_bytes run.h5 "$run"
  run-dem --force packing.h5 short.toml -o "$run" <&- >&- 2>&-
  same_bytes run.h5 "$run"
  homogenize none.h5 --tsv 2> /dev/full || status=$?
  [[ $status -eq 66 ]] || show "status $status"
  call bash -c 'homogenize run.h5 --tsv >&-'
  [[ $status -eq 74 && $stderr == "homogenize: standard output: "* ]] || show "wanted exit status 74"
}

@test "a limit on the size of files is a full disk" {
  cd "$BATS_TEST_TMPDIR"
  call bash -c "ulimit -f 10; exec run-dem --quiet '$BATS_FILE_TMPDIR/packing.h5' '$BATS_FILE_TMPDIR/short.toml' -o out.h5"
  [[ $status -eq 74 && $stderr == "run-dem: out.h5.part/"*"ulimit -f"*"nothing is kept yet: run it again" ]] || show "wrong"
  [[ ! -e out.h5.part ]] || show "something is left"
}

@test "threads that cannot be had are told before the work, and the remedy works" {
  cd "$BATS_TEST_TMPDIR"
  call bash -c "ulimit -v 1500000; exec run-dem --quiet --threads 1000 '$BATS_FILE_TMPDIR/packing.h5' '$BATS_FILE_TMPDIR/short.toml' -o out.h5"
  [[ $status -eq 64 && $stderr == "run-dem: --threads 1000: this process may have "* ]] || show "wrong"
  bash -c "ulimit -v 1500000; exec run-dem --quiet --threads ${stderr##* } --check '$BATS_FILE_TMPDIR/packing.h5' '$BATS_FILE_TMPDIR/short.toml'"
}

@test "output that fails is told with its status" {
  mentions 73 pack-generate "cannot be created" --quiet --import packing.h5 --as-is -o "$BATS_TEST_TMPDIR/none/out.h5"
  [[ -c /dev/full ]] || skip "no /dev/full"
  call bash -c 'pack-generate --quiet --import packing.h5 --as-is -o - > /dev/full'
  [[ $status -eq 74 ]] || show "wanted exit status 74"
}
