#!/usr/bin/env bats
# The rules of the studies: an edited option makes anew the runs that have it, and no others. A script that writes its outputs at once
# takes the place of the tools.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

RUNS=(ch3/uc_PE ch3/ss_2410 ch4/wrapped_PE ch4/layered_PE ch5/uc_2PP ch5/uc_3PP ch5/cell_PE_50kPa)
ALL="ch3/bag ch3/rv ch3/ss_2410 ch3/uc_PE ch4/bag ch4/layered ch4/layered_PE ch4/rv ch4/wrapped ch4/wrapped_PE ch5/cell_PE_50kPa ch5/uc_2PP ch5/uc_3PP"

setup() {
  local tools=$BATS_TEST_TMPDIR/bin tool
  mkdir "$tools"
  cat > "$tools/run-dem" <<'END'
#!/bin/bash
while (($#)); do
  case $1 in -o | --history) echo made > "$2" ;; esac
  shift
done
END
  chmod +x "$tools/run-dem"
  for tool in pack-generate filter-expand homogenize fabric gws-solve fem-dem to-vtk; do ln -s run-dem "$tools/$tool"; done
}

# makes FILES ARGUMENTS...: demands that make with these arguments makes these files, of RUNS and of what they are made from, and no others.
makes() {
  local wanted=$1 out=$BATS_TEST_TMPDIR/out runs=("${RUNS[@]/%/.h5}") made
  shift
  exits 0 study_rules BIN="$BATS_TEST_TMPDIR/bin" OUT="$out" "$@" "${runs[@]/#/$out/}"
  made=$(sed -n "s|.*$out/\(ch.*\)\.h5|\1|p" <<< "$output" | sort | paste -s -d ' ')
  [[ $made == "$wanted" ]] || show "made: $made" "wanted: $wanted"
}

# changes FILES OPTION: makes these files with this option and, when it is taken back, again.
changes() {
  makes "$1" "$2"
  makes "$1"
}

@test "an edited option makes anew the runs that have it, and no others" {
  makes "$ALL"
  makes ""
  changes "ch3/uc_PE" C3_UC_quick="--set stage.1.strain=0.17"
  changes "ch3/ss_2410" C3_SS_quick="--set stage.2.parts=5"
  changes "ch4/layered ch4/layered_PE" C4_FORM_layered_quick="--set surround.rings=1"
  changes "ch4/layered_PE ch4/wrapped_PE ch5/cell_PE_50kPa" C4_LOAD_quick=
  changes "ch5/uc_2PP" C5_FAR_quick="2PP=0.17 3PP=0.17"
  changes "ch5/cell_PE_50kPa" C5_CELL_FAR_quick=PE=5
}

@test "another number of threads makes no run anew" {
  makes "$ALL"
  makes "" C3_THREADS=2 C4_THREADS=2
}

@test "each run of two scales has a forecast of its own, those of one mesh and speed too" {
  local out=$BATS_TEST_TMPDIR/out runs=(pullout_8_0.5 swinging_8_0.5 shape_8_0.5) run
  runs=("${runs[@]/#/$out/ch6/}")
  exits 0 study_rules BIN="$BATS_TEST_TMPDIR/bin" OUT="$out" "${runs[@]/%/.check}"
  for run in "${runs[@]}"; do [[ -e $run.check ]] || show "no $run.check"; done
}

@test "sets are weighed as in the thesis where they are the thesis's: its prior and as many samples" {
  local bin=$BATS_TEST_TMPDIR/bin out=$BATS_TEST_TMPDIR/out
  ln -s run-dem "$bin/pf-weight"
  ln -s run-dem "$bin/plot"
  exits 0 study_rules -n BIN="$bin" OUT="$out" C2_CASES=hm_1000_0.2 PROFILE=thesis ch2
  [[ $output == *"/hm_1000_0.2/thesis_error.tsv"* ]] || show
  exits 0 study_rules -n BIN="$bin" OUT="$out" C2_CASES=hm_1000_0.2 PROFILE=thesis C2_SAMPLES='18 4' ch2
  [[ $output == *hm_1000_0.2* && $output != *thesis_error.tsv* ]] || show "other sets are weighed as the thesis's"
  exits 0 study_rules -n BIN="$bin" OUT="$out" C2_CASES=hm_1000_0.2 PROFILE=quick ch2
  [[ $output == *hm_1000_0.2* && $output != *thesis_error.tsv* ]] || show "the quick sets are weighed as the thesis's"
}

@test "a case of chapter 2 that is none is named, and how one is written" {
  local case
  for case in nonsense hm_1000 xx_1000_0.2; do
    exits 2 study_rules -n BIN="$BATS_TEST_TMPDIR/bin" OUT="$BATS_TEST_TMPDIR/out" C2_CASES="hm_1000_0.2 $case" ch2
    # shellcheck disable=SC2154  # stderr is set by call
    [[ $stderr == *"C2_CASES: $case is no case; write LAW_GRAINS_PRESSURE, as hm_1000_0.2 or cl_5000_0.2"* ]] || show
  done
}
