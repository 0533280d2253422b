#!/usr/bin/env bats
# plot: draws real runs, beside each other and beside test data, in each format, and refuses what it cannot draw.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup_file() {
  load common
  cd "$BATS_FILE_TMPDIR" || return
  cat "$BATS_TEST_DIRNAME/sand.toml" - > short.toml << 'TOML'
[equilibrium]
unbalanced_force = 1e-2

[[stage]]
path = "triaxial"
confining_pressure = "100 kPa"
axial_strain = 0.002
increment = 0.001
rate = 0.5
TOML
  pack-generate --quiet --grains 60 --aspect 1 --pressure 1e5 --tolerance 1e-2 -o packing.h5
  run-dem --quiet packing.h5 short.toml -o run.h5
  homogenize run.h5 --table series --tsv > series.tsv
  printf 'strain_axial [%%]\tstress_ratio [1]\n0\t1\n0.2\t1.5\n' > test.tsv
}

setup() {
  mkdir "$BATS_TEST_TMPDIR/here"
  cd "$BATS_TEST_TMPDIR/here" || return
  ln -s "$BATS_FILE_TMPDIR"/* .
}

@test "a run and its table give the same curves, test data lie beside them" {
  exits 0 plot stress-strain run.h5 --beside test.tsv -o run.svg
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $stderr == "plot: test: has no column strain_volumetric; volumetric strain, contraction positive is without it" ]] || show
  grep -q '>axial strain (%)<' run.svg
  exits 0 plot stress-strain run.h5 -o alone.svg
  ln -s series.tsv run.tsv
  exits 0 plot stress-strain run.tsv -o table.svg
  same_bytes alone.svg table.svg
  exits 0 plot stress-strain run.tsv -o -
  [[ $output == "$(cat table.svg)" ]] || show "standard output has another figure"
}

@test "strains above 1 without a unit are doubted, with --quiet too" {
  printf 'strain_axial\tstress_ratio [1]\n0\t1\n5\t1.5\n' > bare.tsv
  exits 0 plot stress-strain run.h5 --quiet --beside bare.tsv -o bare.svg
  [[ $stderr == "plot: doubt: bare: strain_axial reaches 5, which is 500 %; if 5 % is meant, head it strain_axial [%]" ]] || show
  sed 's/strain_axial/strain_axial [%]/' bare.tsv > headed.tsv
  exits 0 plot stress-strain run.h5 --quiet --beside headed.tsv -o headed.svg
  [[ -z $stderr ]] || show "the remedy does not work"
}

@test "fabric and roses come from the tool that makes them, pictures in every format" {
  exits 0 plot fabric run.h5 -o fabric.pdf
  exits 0 plot rose run.h5 -o rose.png
  exits 0 plot rose run.h5 --stage 0 -o stage.png
  # Doubts of that tool about the drawn state are said, with --quiet too; those about other states are not.
  exits 0 plot rose run.h5 --quiet -o quiet.png
  fabric --tsv --table rose --state last run.h5 2>&1 > /dev/null | sed 's/^fabric: doubt: /plot: doubt: fabric run.h5: /' > said
  [[ -s said && $stderr == "$(cat said)" ]] || show "wanted: $(cat said)"
  [[ $(head -c 4 fabric.pdf) == %PDF && $(head -c 4 rose.png | tail -c 3) == PNG ]] || show
}

@test "what cannot be drawn is refused in one line, with the right status, before anything is written" {
  complains 66 plot "none.h5: no such file; check the name" stress-path none.h5 -o a.svg
  complains 65 plot "test.tsv: has no column mean_stress; known: strain_axial, stress_ratio" stress-path test.tsv -o a.svg
  complains 64 plot "'stresspath' is no kind of plot; did you mean 'stress-path'?" stresspath run.h5 -o a.svg
  complains 64 plot "a.gif: is no picture that plot can write; end it in .svg, .png, .pdf" stress-path run.h5 -o a.gif
  complains 64 plot "--stage first: give a number from 0, last or all" stress-path run.h5 --stage first -o a.svg
  complains 64 plot "--stage ²: give a number from 0, last or all" stress-path run.h5 --stage ² -o a.svg
  complains 65 plot "run.h5: has no stage 7; give one that it has: 0" stress-path run.h5 --stage 7 -o a.svg
  complains 65 plot "run.h5: has no stage 7; give one that it has: 0" rose run.h5 --stage 7 -o a.svg
  complains 64 plot "--beside: rose draws no test data; leave it out" rose run.h5 --beside test.tsv -o a.svg
  complains 64 plot "run.h5 is given twice, and one curve would hide the other: give it once" stress-path run.h5 run.h5 -o a.svg
  complains 64 plot "--force has no effect without a file to write: leave it out" stress-path run.h5 --force
  complains 64 plot "--stage 0: posterior has no stages; leave it out" posterior run.h5 --stage 0 -o a.svg
  complains 65 plot "series.tsv: is no posterior; give the file that pf-weight assimilate writes with -o" posterior series.tsv -o a.svg
  complains 65 plot "packing.h5: holds no densities; pf-weight assimilate writes them with -o" posterior packing.h5 -o a.svg
  complains 73 plot "none/a.svg: cannot be created: none is not a directory; make it first" stress-path run.h5 -o none/a.svg
  complains 73 plot "run.h5/a.svg: cannot be created: run.h5 is a file, not a directory; name another folder" stress-path run.h5 -o run.h5/a.svg
  [[ ! -e a.svg ]] || show "something was written"
  echo mine > a.svg
  complains 73 plot "a.svg: exists; give --force to overwrite it" stress-path run.h5 -o a.svg
  complains 73 plot "a.svg: is read by this command and would be lost; name another file with --output" stress-path a.svg --force -o a.svg
  mkdir folder.svg
  complains 73 plot "folder.svg: is a directory; name a file to be written" stress-path run.h5 --force -o folder.svg
  complains 65 plot ".: is no whole posterior; make it again with pf-weight assimilate" posterior . -o b.svg
  printf '\e[2J [m] [s]\n' > control.tsv
  complains 65 plot "control.tsv: '\x1b[2J [m] [s]' is no head of a column; write \"name [unit]\"" stress-path control.tsv -o b.svg
  local status=0
  plot stress-path none.h5 -o b.svg 2> /dev/full || status=$?
  [[ $status -eq 66 ]] || show "a standard error that cannot be written changes the status"
  [[ $(cat a.svg) == mine ]] || show "a.svg was overwritten"
  exits 0 plot stress-path run.h5 --force -o a.svg
  DISPLAY='' WAYLAND_DISPLAY='' complains 73 plot \
    "no window can be opened here (python3-tk and a display would do); give -o FILE.svg" stress-path run.h5
}

@test "a tool's own message and status come through" {
  printf '\x89HDF\r\n\x1a\nnothing' > broken.h5
  call homogenize broken.h5 --list
  complains "$status" plot "$stderr" stress-path broken.h5 -o b.svg
}

@test "plot has the version of the other tools, and works where it is installed" {
  [[ $(plot --version | head -1) == "plot $(fabric --version | head -1 | cut -d' ' -f2-)" ]] || show
  mkdir -p there/bin there/share/soilweave/python
  cp -L "$BIN/plot" there/bin
  ln -s "$BIN/homogenize" there/bin
  cp -r "$BATS_TEST_DIRNAME/../../pipelines/study" there/share/soilweave/python/study
  exits 0 env PATH=/usr/bin:/bin there/bin/plot e-log-p run.h5 -o there/e.svg
  # Through a link in another folder, plot finds the tools beside the real file.
  mkdir home
  ln -s "$PWD/there/bin/plot" home/plot
  exits 0 env PATH=/usr/bin:/bin home/plot e-log-p run.h5 -o home/e.svg
}
