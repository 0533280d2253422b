#!/usr/bin/env bats
# pipelines/calibrate.sh: rounds over two tests together, their files, resuming, and refusals before anything runs.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

ROOT=$BATS_TEST_DIRNAME/../..

setup() {
  cd "$BATS_TEST_TMPDIR" || return
  command -v parallel >/dev/null || skip "GNU parallel is not installed"
  printf 'axial_strain [%%]\tvolumetric_strain [%%]\tdeviatoric_stress [kPa]\n0\t0\t0\n0.1\t0.05\t50\n0.2\t0.08\t90\n0.3\t0.1\t120\n0.4\t0.1\t140\n' > low.tsv
  awk -F '\t' -v OFS='\t' 'NR > 1 { $3 *= 2 } { print }' low.tsv > high.tsv
}

# calibrate OPTION...: two tests on a small packing, into the folder `case`.
calibrate() {
  "$ROOT/pipelines/calibrate.sh" --prior "$ROOT/pipelines/ch2/prior_quick_hm.toml" --packing packing.h5 --test low.tsv "100 kPa" engineering \
    --test high.tsv "200 kPa" natural --until 0.4 --error stress_ratio=0.5,strain_volumetric=0.05 "$@" case
}

@test "two tests are weighed together until the effective size is reached or the rounds are spent; finished runs stay" {
  pack-generate --grains 200 --pressure 1e4 --void-ratio 0.8 --seed 1 --quiet -o packing.h5
  exits 1 calibrate --samples 5,3 --rounds 2 --effective-size 100
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $stderr == *"after 2 of 2 rounds, below the 100 asked for"*"loading rate: the scenario's"* ]] || show
  [[ -s case/posterior.h5 && -s case/predicted.svg && -s case/posterior.svg ]] || show "$(ls case)"
  # Both tests and all sets of both rounds count.
  [[ $(value case/round2_runs.tsv id last) -eq 7 ]] || show "$(cat case/round2_runs.tsv)"
  near "$(value case/parameters.tsv mean 5)" "$(value case/round2_steps.tsv friction_angle last)" 1e-4
  [[ $(value case/predicted_low_100kPa.tsv stress_ratio_observed 1) == 1.5 ]] || show "$(cat case/predicted_low_100kPa.tsv)"
  [[ $(value case/misfits.tsv test last) == high_200kPa ]] || show "$(cat case/misfits.tsv)"
  exits 0 calibrate --samples 5,3 --rounds 2 --effective-size 1
  [[ $output != *"  run  "* && $output == *"after 1 of 2 rounds; loading rate"* ]] || show "finished runs were made again, or rounds after the size"
}

@test "a tool that is missing is told before anything runs" {
  mkdir some && ln -s "$BIN"/{run-dem,homogenize,pf-weight} some/
  : > packing.h5
  BIN=$PWD/some exits 69 calibrate --samples 5
  [[ $stderr == "calibrate: $PWD/some lacks plot: make all builds them, and BIN=FOLDER names another folder" && ! -e case/runs ]] || show
}

@test "a test without a curve is its greatest stress ratio alone, weighed and predicted, whatever columns it has" {
  pack-generate --grains 200 --pressure 1e4 --void-ratio 0.8 --seed 1 --quiet -o packing.h5
  printf 'stress_ratio_peak [1]\n2.5\n' > alone.tsv
  printf 'stress_ratio_peak [1]\tconfining_pressure [kPa]\n2.4\t300\n' > other.tsv
  exits 0 "$ROOT/pipelines/calibrate.sh" --prior "$ROOT/pipelines/ch2/prior_quick_hm.toml" --packing packing.h5 --test low.tsv "100 kPa" engineering \
    --test alone.tsv "200 kPa" greatest --predict other.tsv "300 kPa" greatest --until 0.4 --samples 3 --rounds 1 --effective-size 0 case
  [[ $(value case/alone_200kPa_curves.tsv stress_ratio_peak_observed 1) == 2.5 ]] || show "$(cat case/alone_200kPa_curves.tsv)"
  [[ $(value case/other_300kPa_curves.tsv confining_pressure 1) == 300 && -s case/posterior.h5 ]] || show "$(ls case)"
}

@test "what is wrong with a test is one line, before anything runs" {
  touch packing.h5
  sed -i 's/^0.4.*/0.4\t0.1\t-140/' high.tsv
  exits 65 calibrate
  [[ $stderr == "calibrate: high.tsv: "*"change the signs" && ! -e case/low_100kPa/runs ]] || show
  awk -F '\t' -v OFS='\t' 'NR > 1 { $3 *= 2 } { print }' low.tsv > high.tsv
  exits 64 calibrate --error stres_ratio=0.2
  [[ $stderr == "calibrate: an error is given for stres_ratio, which low.tsv does not tell; did you mean 'stress_ratio'?" ]] || show
  exits 64 calibrate --error stress_ratio=0.2,stress_ratio_peak=0.1
  [[ $stderr == *"stress_ratio_peak, which no test tells; leave it out" ]] || show
  cp low.tsv copy.csv
  exits 65 calibrate --predict copy.csv "100 kPa" engineering --rounds 1
  [[ $stderr == "calibrate: copy.csv: has 4 of 4 rows of low.tsv: a test counts once, and cannot predict itself; leave one of them out" ]] || show
  sed 's/"friction_angle"/"sliding_damping"/' "$ROOT/pipelines/own/prior.toml" > prior.toml
  exits 65 calibrate --prior prior.toml
  [[ $stderr == "calibrate: prior.toml: no run depends on a parameter named 'sliding_damping'; known: young_modulus, "* ]] || show
  exits 64 calibrate --error stress_ratio=0.2,stress_ratio=0.3
  [[ $stderr == *'"stress_ratio=0.2,stress_ratio=0.3": a name is there twice; leave one of them out'* ]] || show
  exits 64 calibrate --at 0.2,x
  [[ $stderr == *'argument --at: "x": give a number of at least 0'* ]] || show
  exits 64 calibrate --error 0.1 --variance stress_ratio=0.1
  [[ $stderr == "calibrate: --error and --variance both say how exact the tests are: give one of them; --help tells the options" ]] || show
}
