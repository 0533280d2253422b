#!/usr/bin/env bats
# pf-weight: what its verbs print and write, the tables of thesis chapter 2, pipes, refusals and reports.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup() {
  cd "$BATS_TEST_TMPDIR" || return
  cp "$BATS_TEST_DIRNAME"/examples/{prior.toml,observed.tsv,runs.tsv} .
}

# refuses STATUS VERB MESSAGE ARGUMENTS...: demands exactly these lines, each "pf-weight VERB: MESSAGE", and an empty
# standard output.
refuses() {
  local wanted=$1 verb=$2 message=$3
  shift 3
  exits "$wanted" pf-weight "$verb" "$@"
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $stderr == "pf-weight $verb: $message" ]] || show "wanted: pf-weight $verb: $message"
  [[ -z $output ]] || show "wanted nothing on standard output"
}

thesis_prior() {
  cat <<'TOML'
[[parameter]]
name = "young_modulus"
unit = "Pa"
scale = "log"
low = 1e7
high = 1e11
[[parameter]]
name = "poisson_ratio"
low = 0
high = 0.5
[[parameter]]
name = "rolling_stiffness"
low = 0
high = 1
[[parameter]]
name = "rolling_limit"
low = 0
high = 1
[[parameter]]
name = "friction_angle"
unit = "deg"
low = 0
high = 60
TOML
}

@test "draw: the thesis's table has bases 2, 5, 7, 9, 11 and begins with the origin" {
  thesis_prior > thesis.toml
  exits 0 pf-weight draw thesis.toml --samples 2000 --bases 2,5,7,9,11 --tsv
  [[ ${#lines[@]} -eq 2001 ]] || show "${#lines[@]} lines"
  [[ ${lines[0]} == $'id [1]\tyoung_modulus [Pa]\tpoisson_ratio [1]\trolling_stiffness [1]\trolling_limit [1]\tfriction_angle [deg]' ]] || show
  [[ ${lines[1]} == $'0\t1e+07\t0\t0\t0\t0' || ${lines[1]} == $'0\t10000000\t0\t0\t0\t0' ]] || show "${lines[1]}"
  # Row 10: 1010, 20, 13, 11, 0.1 in the bases; 0.0101 = 5/16, 0.02 = 2/25, 0.31 = 22/49, 0.11 = 10/81, 0.01... of 11.
  awk -F '\t' 'function near(a, b) { return (a - b) ^ 2 <= (1e-12 * b) ^ 2 }
    $1 == 10 { good = near($2, 10 ^ (7 + 4 * 5 / 16)) && near($3, 0.5 * 2 / 25) && near($4, 22 / 49) && near($5, 10 / 81) &&
      near($6, 60 * 10 / 11) } END { exit !good }' <<<"$output" || show "row 10: ${lines[11]}"
}

@test "draw: every row of the author's three tables, by radical inverses in whole numbers" {
  thesis_prior > wide.toml
  sed 's/low = 1e7/low = 5.4e8/; s/high = 1e11/high = 5.5e8/; s/high = 0.5/high = 0.2/; s/high = 60/high = 31/' wide.toml |
    awk '/^name/ { name = $3 } name ~ /rolling_stiffness/ { sub(/low = 0/, "low = 0.5"); sub(/high = 1$/, "high = 0.6") }
      name ~ /rolling_limit/ { sub(/low = 0/, "low = 0.1"); sub(/high = 1$/, "high = 0.2") }
      name ~ /friction/ { sub(/low = 0/, "low = 29") } { print }' > narrow.toml
  local table
  # Prior, sets, first index, bases, and the ranges once more.
  for table in 'wide 2000 0 2,5,7,9,11 1e7,1e11 0,0.5 0,1 0,1 0,60' 'wide 1000 1 2,3,5,7,11 1e7,1e11 0,0.5 0,1 0,1 0,60' \
    'narrow 100 1 2,3,5,7,11 5.4e8,5.5e8 0,0.2 0.5,0.6 0.1,0.2 29,31'; do
    # shellcheck disable=SC2086  # words of the table
    set -- $table
    exits 0 pf-weight draw "$1.toml" -n "$2" --first "$3" --bases "$4" --tsv
    awk -v first="$3" -v bases="$4" -v ranges="$5 $6 $7 $8 $9" -v rows="$2" -F '\t' '
      BEGIN { split(bases, base, ","); split(ranges, range, " ") }
      NR > 1 { for (k = 1; k <= 5; ++k) {
          over = 0; under = 1
          for (i = $1 + first; i > 0; i = int(i / base[k])) { over = over * base[k] + i % base[k]; under *= base[k] }
          split(range[k], end, ",")
          u = over / under; value = k == 1 ? end[1] * exp(u * log(end[2] / end[1])) : end[1] + u * (end[2] - end[1])
          if (sprintf("%.6g", value) != sprintf("%.6g", $(k + 1))) { print "row " $1 " column " k ": " $(k + 1) ", not " value; ++wrong } } }
      END { exit !(NR == rows + 1 && !wrong) }' <<<"$output" || show "$table"
  done
}

@test "draw: the stored table of 100 sets, digit by digit" {
  needs_reference ch2/mc100_parameters.csv
  cat > mc100.toml <<'TOML'
parameter = [
  { name = "E_Pa", unit = "Pa", scale = "log", low = 5.4e8, high = 5.5e8 },
  { name = "nu", low = 0, high = 0.2 },
  { name = "kr", low = 0.5, high = 0.6 },
  { name = "eta", low = 0.1, high = 0.2 },
  { name = "mu_deg", unit = "deg", low = 29, high = 31 },
]
TOML
  pf-weight draw mc100.toml -n 100 --bases 2,3,5,7,11 --first 1 --tsv |
    awk -F '\t' 'NR > 1 { printf "%d", $1; for (i = 2; i <= NF; ++i) printf ",%.6g", $i; print "" }' > drawn
  # shellcheck disable=SC2154  # reference is set by needs_reference
  tail -n +2 "$reference" > published
  same_bytes drawn published
}

@test "draw: table and file say the same, a pipe too, and the same call gives the same bytes" {
  pf-weight draw prior.toml -n 20 --method sobol --tsv -o one.h5 > one.tsv
  pf-weight draw prior.toml -n 20 --method sobol -o - > other.h5
  same_bytes one.h5 other.h5
  exits 0 "$PYTHON" - <<'PY'
import h5py
rows = [line.rstrip("\n").split("\t") for line in open("one.tsv")]
with h5py.File("one.h5") as file:
    assert file.attrs["kind"] in ("ensemble", b"ensemble")
    assert "low = -2" in file["prior"][()].decode()
    for i, head in enumerate(rows[0]):
        name, unit = head.split(" [")
        assert file["members"][name][()].tolist() == [float(row[i]) for row in rows[1:]], name
PY
  pf-weight draw prior.toml -n 20 --method latin-hypercube --seed 5 --tsv > one.tsv
  pf-weight draw prior.toml -n 20 --method latin-hypercube --seed 5 --tsv > other.tsv
  same_bytes one.tsv other.tsv
  exits 73 pf-weight draw prior.toml -n 20 -o one.h5
  [[ $stderr == *"one.h5"*"--force"* ]] || show
}

@test "draw: what is wrong with a prior or the options is said" {
  refuses 64 draw "nothing to do: give --tsv or -o FILE" prior.toml
  refuses 64 draw "--bases 2,4: 2 and 4 share a factor, so that the points would lie on lines; choose others" \
    prior.toml --bases 2,4 --tsv
  refuses 64 draw "--bases 2,3,5: 3 for 2 parameters; give one for each" prior.toml --bases 2,3,5 --tsv
  refuses 64 draw "--seed has no effect on a sequence; for other sets of it give --first, as 101" prior.toml --seed 2 --tsv
  exits 0 pf-weight draw prior.toml -n 2 --first 101 --tsv
  refuses 64 draw "--bases: only the Halton sequence has bases" prior.toml --bases 2,3 --method sobol --tsv
  refuses 66 draw "none.toml: no such file; check the name" none.toml --tsv
  printf '[[parameter]]\nname = "E"\nscale = "log"\nlow = 0\nhigh = 1\n' > bad.toml
  refuses 65 draw "bad.toml:4: parameter.0.low: 0 on a log scale; must be above 0" bad.toml --tsv
  printf '[[parameter]]\nname = "E"\nlow = 2\nhigh = 1\n' > bad.toml
  refuses 65 draw "bad.toml:4: parameter.0.high: 1 is not above low, 2" bad.toml --tsv
  printf 'title = 1\n' > bad.toml
  exits 65 pf-weight draw bad.toml --tsv
  [[ $stderr == *"no parameters; give [[parameter]] tables with name, low and high"* ]] || show
}

@test "assimilate: the stored ensemble has the expected means, weights and degeneracy" {
  needs_reference ch2/mc100_simulations.csv
  local folder=${reference%/*}
  sed '1s/.*/id,E_Pa,nu,kr,eta,mu_deg/; s/,/\t/g' "$folder/mc100_parameters.csv" > sets.tsv
  sed '1s/.*/id,step,eps_r,ratio,eps_v/; s/,/\t/g' "$folder/mc100_simulations.csv" > runs.tsv
  awk -F , 'BEGIN { print "step\teps_r\tratio\teps_v" } NR > 1 { print NR - 1 "\t" $2 "\t" $3 "\t" $4 }' \
    "$folder/toyoura_obs_0.5MPa_100steps.csv" > observed.tsv
  exits 0 pf-weight assimilate sets.tsv observed.tsv --runs runs.tsv --variance 0.1 --tsv
  [[ $stderr == *"degenerate: an effective sample size of 1.055 of 100 for 5 parameters"*"0.973 of the weight is on member 50"* ]] || show
  awk -F '[\t,]' 'NR == FNR { if (FNR > 1) for (i = 2; i <= 6; ++i) wanted[FNR - 1, i - 1] = $i; next }
    FNR == 1 { for (i = 1; i <= NF; ++i) { split($i, part, / \[/); at[part[1]] = i } next }
    { n = split("E_Pa nu kr eta mu_deg", name, " ")
      for (k = 1; k <= n; ++k) { d = $at[name[k]] / wanted[FNR - 1, k] - 1; if (d < 0) d = -d; if (d > most) most = d } }
    END { exit !(FNR == 101 && most < 1e-6) }' "$folder/mc100_expected_weighted_means_var0.1.csv" - <<<"$output" ||
    show "means differ"
}

@test "assimilate: text, table, file and pipe agree; files open elsewhere and tell their history" {
  pf-weight draw prior.toml -n 100 -o ensemble.h5
  exits 0 pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --variance 0.01
  [[ $output == "100 parameter sets, 100 runs used."* ]] || show
  pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --variance 0.01 --at 2 --tsv -o posterior.h5 > steps.tsv
  pf-weight draw prior.toml -n 100 -o - | pf-weight assimilate - observed.tsv --runs runs.tsv --variance 0.01 --at 2 -o - > piped.h5
  same_bytes posterior.h5 piped.h5
  exits 0 "$PYTHON" - <<'PY'
import h5py, math
rows = [line.rstrip("\n").split("\t") for line in open("steps.tsv")]
with h5py.File("posterior.h5") as file:
    fields = file["fields"]
    assert sorted(fields) == ["covariance", "density", "rounds", "runs", "steps", "weights"]
    for i, head in enumerate(rows[0]):
        assert fields["steps"][head.split(" [")[0]][()].tolist() == [float(row[i]) for row in rows[1:]], head
    weight = file["members/weight"][()]
    assert abs(weight.sum() - 1) < 1e-12
    assert abs(fields["steps/effective_size"][-1] - 1 / (weight ** 2).sum()) < 1e-9
    for name in ("a", "b"):
        assert abs((file["members"][name][()] * weight).sum() - fields["steps"][name][-1]) < 1e-12
PY
  exits 0 to-vtk --history posterior.h5
  [[ $output == *"pf-weight draw"*"pf-weight assimilate"*"runs"* ]] || show
  exits 65 to-vtk posterior.h5 -o pictures
  exits 65 homogenize posterior.h5 --tsv
  exits 65 pf-weight resample ensemble.h5 -n 5 --tsv
  [[ $stderr == "pf-weight resample: ensemble.h5: has no weights; assimilate observations first" ]] || show
}

@test "assimilate: runs that are missing, failed or diverged are listed and have no weight" {
  pf-weight draw prior.toml -n 4 -o ensemble.h5
  mkdir runs
  awk -F '\t' '/^#/ { next } $1 == "id" { for (i = 2; i <= NF; ++i) head = head (i > 2 ? "\t" : "") $i; next }
    $1 < 4 { file = "runs/" $1 ".tsv"; if (!(file in seen)) { print head > file; seen[file] = 1 } print $2 "\t" $3 "\t" $4 > file }' runs.tsv
  rm runs/0.tsv
  sed -i '$ s/[^\t]*$/nan/' runs/1.tsv
  exits 0 pf-weight assimilate ensemble.h5 observed.tsv --runs 'runs/{id}.tsv' --variance 0.01
  [[ $output == *"4 parameter sets, 2 runs used, 1 missing, 1 diverged; those have no weight:"* ]] || show
  [[ $output == *"  0 missing: runs/0.tsv: no such file"* ]] || show
  [[ $output == *"  1 diverged: two at t 5 is not finite"* ]] || show
  [[ $stderr == *"2 of 4 runs are not used and have no weight: member 0, missing (runs/0.tsv: no such file); member 1, diverged (two at t 5 is \
not finite); make such runs anew, or mend their tables"* ]] || show
  cp runs/2.tsv runs/0.tsv
  exits 0 pf-weight assimilate ensemble.h5 observed.tsv --runs 'runs/{id}.tsv' --variance 0.01
  [[ $stderr == *"1 of 4 runs is not used and has no weight: member 1, diverged"* && $stderr == *"each is weighted: 2 as 0; give each its own run"* ]] || show
  rm runs/0.tsv
  exits 0 pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --variance 0.01
  [[ $stderr == *"ids in --runs that no member of the ensemble has: 96, the first 4; their rows are left out"* ]] || show
  exits 0 pf-weight assimilate ensemble.h5 observed.tsv --runs 'runs/{id}.tsv' --variance 0.01 --tsv --table runs
  [[ ${lines[1]} == $'0\t1\tnan\t0\tnan'* && ${lines[2]} == $'1\t4\tnan\t0\tnan'* ]] || show
  [[ ${lines[0]} == *$'\tone_misfit\tone_misfit_relative [1]\ttwo_misfit\ttwo_misfit_relative [1]' ]] || show
  exits 0 pf-weight assimilate ensemble.h5 observed.tsv --runs 'runs/{id}.tsv' --variance 0.01 --tsv --table curves
  [[ ${lines[0]} == $'id [1]\tstep [1]\tt\tone\tone_observed\ttwo\ttwo_observed' ]] || show
  [[ ${#lines[@]} -eq 11 && ${lines[1]} == 2$'\t'1$'\t'1$'\t'* && ${lines[6]} == 3$'\t'* ]] || show "five stations of two runs: $output"
  rm -r runs
  exits 65 pf-weight assimilate ensemble.h5 observed.tsv --runs 'runs/{id}.tsv' --variance 0.01
  [[ $stderr == "pf-weight assimilate: none of 4 runs can be used; the first: runs/0.tsv: no such file" ]] || show
}

@test "assimilate: observations with NaN, repeated or unreached stations get a clear message" {
  pf-weight draw prior.toml -n 10 -o ensemble.h5
  local try=(ensemble.h5 bad.tsv --runs runs.tsv --variance 0.01)
  sed '4 s/[^\t]*$/nan/' observed.tsv > bad.tsv
  refuses 65 assimilate "bad.tsv: row 2: two is not finite; take the row out, or leave the column out by --observe" "${try[@]}"
  { cat observed.tsv; tail -n 1 observed.tsv; } > bad.tsv
  refuses 65 assimilate "bad.tsv: row 6: t 5 is not above 5; sort the rows, keep one of equal ones" "${try[@]}"
  { cat observed.tsv; printf '9\t1\t1\n'; } > bad.tsv
  refuses 65 assimilate "none of 10 runs can be used; the first: ends at t 5, the observations at 9" "${try[@]}"
  exits 0 pf-weight assimilate "${try[@]}" --until 5
  sed -E '/^#/!s/(^|\t)t\t/\1t [%]\t/' bad.tsv > per_cent.tsv
  sed -E '/^#/!s/(^|\t)t\t/\1t [%]\t/' runs.tsv > runs_per_cent.tsv
  try=(ensemble.h5 per_cent.tsv --runs runs_per_cent.tsv --variance 0.01)
  exits 0 pf-weight assimilate "${try[@]}" --until "5 %"
  refuses 65 assimilate "per_cent.tsv: no observations up to --until 0.5 %: the first is at 1 %" "${try[@]}" --until "0.5 %"
  refuses 64 assimilate '--until: "x" is no finite number' "${try[@]}" --until x
  exits 65 pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --variance 0.01 --observe three
  [[ $stderr == *"no column three among "* ]] || show
  exits 65 pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --variance 0.01 --observe one=three
  [[ $stderr == *": runs.tsv: run of member 0: no column three"* ]] || show
  printf 'id\tt\tone\ttwo\n0.5\t1\t1\t1\n' > bad.tsv
  refuses 65 assimilate "bad.tsv: row 1: id 0.5 is no whole number" ensemble.h5 observed.tsv --runs bad.tsv --variance 0.01
  refuses 64 assimilate "--runs {id:1000000000}: the member's number is too wide; write it as {id} or {id:06}" ensemble.h5 observed.tsv --runs '{id:1000000000}' --variance 0.01
}

@test "assimilate --greatest: a single observed value is compared with the greatest of each run" {
  pf-weight draw prior.toml -n 3 -o ensemble.h5
  printf 'pressure [kPa]\tpeak [1]\n200\t4.5\n400\t4.2\n' > peak.tsv
  printf 'id\tstage\tratio\n0\t0\t9\n0\t1\t4\n0\t1\t5\n1\t1\t4.4\n1\t1\t1\n2\t1\tnan\n2\t1\t1\n' > runs.tsv
  local try=(ensemble.h5 peak.tsv --runs runs.tsv --where stage=1 --observe peak=ratio --variance 0.01 --greatest --tsv --table curves)
  exits 0 pf-weight assimilate "${try[@]}" --until 200
  [[ ${lines[1]} == $'0\t1\t200\t5\t4.5' && ${lines[2]} == $'1\t1\t200\t4.4\t4.5' && ${#lines[@]} -eq 3 ]] || show
  refuses 65 assimilate "peak.tsv: 2 rows where --greatest compares one value of a run: keep the row of its test, or end at it with --until" "${try[@]}"
  refuses 64 assimilate "--station has no effect beside --greatest without --until, where no station counts: leave it out" \
    "${try[@]}" --station ratio
  refuses 64 assimilate "--at has no effect beside --greatest, which compares at no station: leave it out" "${try[@]}" --until 200 --at 2
  # Two runs of one id are told: by the rows where nothing else tells them apart, else by a time, step or strain that falls.
  [[ $stderr != *"several runs"* ]] || show
  printf '1\t1\t4\n1\t1\t4\n' >> runs.tsv
  exits 0 pf-weight assimilate "${try[@]}" --until 200
  [[ $stderr == *"doubt: the greatest values may be those of several runs under one id: member 1, which has 4 rows where most have 2; give each run its own id"* ]] || show
  printf 'id\ttime\tratio\n0\t0\t1\n0\t1\t5\n0\t0\t1\n0\t1\t4\n1\t0\t1\n1\t1\t5\n2\t0\t1\n2\t2\t5\n2\t1.5\t4\n' > runs.tsv
  exits 0 pf-weight assimilate ensemble.h5 peak.tsv --runs runs.tsv --observe peak=ratio --variance 0.01 --greatest --until 200
  [[ $stderr == *"under one id: member 0, whose time falls from 1 to 0 in row 3; give"* ]] || show
}

@test "assimilate: likelihoods that are all zero are told, with status 1 and numbers all the same" {
  pf-weight draw prior.toml -n 10 -o ensemble.h5
  exits 1 pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --variance 1e-12 --tsv
  [[ $output != *nan* && ${#lines[@]} -eq 6 ]] || show
  [[ $stderr == *"at t 1 every likelihood is zero: the nearest run has a squared deviation of "*" variances"* ]] || show
}

@test "assimilate: observations that no run comes near, as in another unit, are told, also where the error is searched" {
  printf '[[parameter]]\nname = "b"\nlow = 1\nhigh = 2\n' > slope.toml
  pf-weight draw slope.toml -n 20 -o slope.h5
  pf-weight draw slope.toml -n 20 --tsv | awk -F '\t' 'NR == 1 { print "id\tx [%]\tq [kPa]" }
    NR > 1 { for (x = 0; x <= 5; ++x) print $1 "\t" x "\t" $2 * x }' > straight.tsv
  local head try=(slope.h5 q.tsv --runs straight.tsv --covariance largest --tsv)
  local far="no run comes near the observations: every run is off by"
  for head in kPa Pa; do
    printf 'x [%%]\tq [%s]\n1\t1.5\n2\t3\n3\t4.5\n4\t6\n' "$head" > q.tsv
    exits 0 pf-weight assimilate "${try[@]}" --least-size 0.3
    [[ $head == kPa || $stderr == *"$far "*" % or more of the observed q; check the units in the heads of both tables"* ]] || show "$head"
    [[ $head != kPa || -z $stderr ]] || show "$head"
  done
  sed -i 's/Pa/MPa/' q.tsv
  exits 0 pf-weight assimilate "${try[@]}" --error 0.3
  [[ $stderr == *"$far 100 % or more of the observed q; check the units"* ]] || show
  # A deviation of ten standard deviations of the given error, though the runs have the size of the observations.
  printf 'x [%%]\tq [kPa]\n1\t2.5\n2\t5\n3\t7.5\n4\t10\n' > q.tsv
  exits 0 pf-weight assimilate "${try[@]}" --error 0.02 --quiet -o far.h5
  [[ $stderr == "pf-weight assimilate: doubt: no run comes near the observations: the nearest run has a squared deviation of "*" variances per observation; check the units"* ]] || show
  # Tables without weights say nothing about them.
  exits 0 pf-weight assimilate "${try[@]}" --error 0.02 --table steps --quiet
  [[ $stderr == *"doubt: degenerate: "* ]] || show
  exits 0 pf-weight assimilate "${try[@]}" --error 0.02 --table runs --quiet
  [[ $stderr == *"doubt: no run comes near"* && $stderr != *degenerate* ]] || show
  [[ $(to-vtk --history far.h5) == *"far: no run comes near the observations"* ]] || show "no doubt in the file"
  exits 0 pf-weight assimilate "${try[@]}" --least-size 0.3
  [[ $stderr != *"comes near"* ]] || show
}

@test "assimilate: the error that keeps a share of the sets effective" {
  pf-weight draw prior.toml -n 100 -o ensemble.h5
  exits 0 pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --least-size 0.3 --tsv
  table '{ size = c("effective_size"); if (NR == 2 || size < least) least = size } END { exit !(least > 29.99 && least < 30.01) }' <<<"$output" || show
  exits 0 pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --covariance component --variance 0.01,0.02
  [[ $output == *"standard deviation of their error: one 0.1, two 0.1414."* ]] || show
  exits 0 pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --covariance component --error 0.1,0.1414
  [[ $output == *"standard deviation of their error: one 0.1, two 0.1414."* && $stderr == *"--error 0.1,0.1414 is a standard deviation; for what used to be --error, a variance, write --variance 0.1,0.1414"* ]] || show
  refuses 64 assimilate "--error and --variance both say how exact the observations are: give one of them" \
    ensemble.h5 observed.tsv --runs runs.tsv --error 0.1 --variance 0.01
  refuses 64 assimilate "--covariance largest: an error that is a share has no --variance; give --error, its standard deviation" \
    ensemble.h5 observed.tsv --runs runs.tsv --covariance largest --variance 0.01
  refuses 64 assimilate "how exact are the observations? Give --error, as 0.1, or --least-size, as 0.2" \
    ensemble.h5 observed.tsv --runs runs.tsv
  refuses 64 assimilate "--error 0.1,x: give numbers above 0, as 0.1 or 0.1,0.02" ensemble.h5 observed.tsv --runs runs.tsv --error 0.1,x
  refuses 64 assimilate "no runs: give --runs, as 'runs/{id}/run.h5'" ensemble.h5 observed.tsv --error 1
  refuses 65 assimilate "errors: 2 given; one is needed, or --covariance component" \
    ensemble.h5 observed.tsv --runs runs.tsv --variance 0.1,0.2
}

@test "assimilate --continue: two tests one after the other weigh as their stations in one table" {
  pf-weight draw prior.toml -n 50 -o ensemble.h5
  pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --error 0.3 --tsv --table runs --quiet > whole.tsv
  pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --error 0.3 --until 2 --quiet -o first.h5 > /dev/null
  awk 'NR == 1 || $1 > 2' observed.tsv > rest.tsv
  pf-weight assimilate first.h5 rest.tsv --runs runs.tsv --error 0.3 --continue --tsv --table runs --quiet -o both.h5 > parts.tsv
  near "$(value parts.tsv weight 7)" "$(value whole.tsv weight 7)" 1e-9
  near "$(value parts.tsv weight 20)" "$(value whole.tsv weight 20)" 1e-9
  exits 0 pf-weight resample both.h5 --keep -n 5 --tsv -o next.h5
  refuses 65 assimilate "--continue: the ensemble has no weights to begin with; give the file that assimilate wrote" \
    ensemble.h5 observed.tsv --runs runs.tsv --error 0.3 --continue
}

@test "assimilate --continue: observations that have weighed the sets already are refused, other observables of their table are not" {
  pf-weight draw prior.toml -n 50 -o ensemble.h5
  local try=(--runs runs.tsv --variance 0.1 --quiet)
  pf-weight assimilate ensemble.h5 observed.tsv "${try[@]}" --observe one -o one.h5 > steps.txt
  cp observed.tsv again.tsv
  refuses 65 assimilate "again.tsv: one has weighed these sets already, and would count twice; leave --continue out, or give the observations of another test" \
    one.h5 again.tsv "${try[@]}" --continue
  exits 0 pf-weight assimilate one.h5 again.tsv "${try[@]}" --continue --observe two=two -o both.h5
  [[ $stderr != *"left out, and this test"* ]] || show "nothing counts twice"
  refuses 65 assimilate "observed.tsv: one has weighed these sets already, and would count twice; leave --continue out, or give the observations of another test" \
    both.h5 observed.tsv "${try[@]}" --continue --observe one=two
  # A round that is drawn anew begins without weights, and the tests of the round before may come again.
  pf-weight resample both.h5 -n 5 --keep --quiet --tsv -o next.h5 > sets.tsv
  exits 0 pf-weight assimilate next.h5 observed.tsv "${try[@]}" --observe one -o one.h5 --force
  exits 0 pf-weight assimilate one.h5 observed.tsv "${try[@]}" --continue --observe two
}

@test "assimilate: weights that an ensemble has and that are left out are told, and the file says so" {
  pf-weight draw prior.toml -n 50 -o ensemble.h5
  pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --variance 0.1 --quiet -o first.h5 > first.txt
  exits 0 pf-weight assimilate first.h5 observed.tsv --runs runs.tsv --variance 0.1 --quiet -o second.h5
  local said="the weights that the ensemble has from an earlier test are left out, and this test counts alone; give --continue for both to count"
  [[ $stderr == "pf-weight assimilate: doubt: $said"* ]] || show
  exits 0 to-vtk --history second.h5
  [[ $(grep -c "  doubt: weights: $said" <<< "$output") -eq 1 ]] || show
}

# logs TABLE: the runs of these sets, whose only value at station 1 is the log of the parameter.
logs() {
  awk -F '\t' 'BEGIN { print "id\tx [1]\ty [1]" } NR > 1 { printf "%d\t0\t0\n%d\t1\t%.9g\n", $1, $1, log($2) / log(10) }' "$1"
}

@test "a prior on a log scale outlasts a table of its sets, or a doubt says what is taken instead" {
  printf '[[parameter]]\nname = "a"\nunit = "Pa"\nscale = "log"\nlow = 1e8\nhigh = 1e10\n' > log.toml
  sed 's/"log"/"linear"/' log.toml > linear.toml
  pf-weight draw log.toml -n 200 --tsv -o ens.h5 > sets.tsv
  printf 'x [1]\ty [1]\n0\t0\n1\t9\n' > flat.tsv
  logs sets.tsv > runs.tsv
  local try=(flat.tsv --runs runs.tsv --error 1000) given
  exits 0 pf-weight assimilate sets.tsv "${try[@]}" --quiet
  [[ $stderr == "pf-weight assimilate: doubt: the table of sets names no prior, so that all values between their least and greatest count as equally likely: a 1e+08 to "*" Pa, linear; give assimilate the prior that they were drawn from, with --prior"$'\n'"pf-weight assimilate: doubt: nothing is learnt: "* ]] || show
  # An error that leaves the likelihood flat leaves the prior, whose mean is (high - low) / ln(high / low), or 2.15e9.
  for given in "sets.tsv --prior log.toml" ens.h5 "ens.h5 --prior log.toml"; do
    # shellcheck disable=SC2086  # words of the list
    exits 0 pf-weight assimilate $given "${try[@]}" -o post.h5 --force
    [[ $stderr == *"nothing is learnt: the observations leave 1 of the weights before them effective; give a smaller error"* && $stderr != *"names no prior"* ]] || show "$given"
    pf-weight resample post.h5 -n 400 --seed 1 --quiet --tsv -o next.h5 --force > next.tsv
    logs next.tsv > next_runs.tsv
    pf-weight assimilate next.h5 flat.tsv --runs next_runs.tsv --error 1000 --quiet --tsv > steps.tsv
    near "$(value steps.tsv a last)" 2.15e9 2e8
  done
  refuses 65 assimilate "ens.h5: its sets are drawn from a 1e+08 to 1e+10 Pa, log; --prior linear.toml has a 1e+08 to 1e+10 Pa, linear: leave --prior out, or draw sets from the other prior" \
    ens.h5 "${try[@]}" --prior linear.toml
  printf 'id\ta [Pa]\tweight\n0\t1e8\t0.5\n1\t1e9\t0.5\n' > weighed.tsv
  exits 0 pf-weight resample weighed.tsv -n 4 -o out.h5
  [[ $stderr == *"pf-weight resample: doubt: the table of sets names no prior"* ]] || show
}

@test "assimilate: one error for observables of different units is refused, and so is a share above 1" {
  pf-weight draw prior.toml -n 100 -o ensemble.h5
  sed -E '/^#/!s/\tone\ttwo/\tone [kPa]\ttwo [%]/' observed.tsv > units.tsv
  sed -E '/^#/!s/\tone\ttwo/\tone [kPa]\ttwo [%]/' runs.tsv > unit_runs.tsv
  local try=(ensemble.h5 units.tsv --runs unit_runs.tsv --quiet) size
  for size in "--error 0.3" "--variance 0.1" "--least-size 0.3"; do
    # shellcheck disable=SC2086  # option and value
    refuses 65 assimilate "one is in kPa and two in %: one error for both would mean another thing in other units; give --covariance component with an error for each, or --covariance largest with a share, as --error 0.05" \
      "${try[@]}" $size
  done
  exits 0 pf-weight assimilate "${try[@]}" --error 0.3 --observe one
  exits 0 pf-weight assimilate "${try[@]}" --covariance component --variance 0.1,0.2
  exits 0 pf-weight assimilate "${try[@]}" --covariance largest --least-size 0.3
  exits 0 pf-weight assimilate "${try[@]}" --covariance largest --error 0.3
  local share=$output
  exits 0 pf-weight assimilate "${try[@]}" --covariance largest --error "30 %"
  [[ $output == "$share" ]] || show "a share in per cent"
  refuses 64 assimilate '--error 5: is a share with --covariance largest, and above 1; write 5 per cent as 0.05 or "5 %"' "${try[@]}" --covariance largest --error 5
  refuses 64 assimilate '--error x %: give a share above 0, as 0.05 or "5 %"' "${try[@]}" --covariance relative --error "x %"
  refuses 64 assimilate '--error 5 %: give numbers above 0, as 0.1 or 0.1,0.02; a share of the observations goes with --covariance largest' "${try[@]}" --error "5 %"
}

@test "draw: a prior whose numbers are those of another unit is doubted" {
  printf '[[parameter]]\nname = "mu"\nunit = "deg"\nlow = 0.1\nhigh = 0.6\n' > unit.toml
  exits 0 pf-weight draw unit.toml -n 2 --tsv --quiet
  [[ $stderr == "pf-weight draw: doubt: mu lies between 0.1 and 0.6 deg; if radians are meant, write low = 5.73 and high = 34.38" ]] || show
  printf '[[parameter]]\nname = "E"\nunit = "MPa"\nlow = 1e7\nhigh = 1e9\n' > unit.toml
  exits 0 pf-weight draw unit.toml -n 2 -o unit.h5
  [[ $stderr == 'pf-weight draw: doubt: E lies between 1e+07 and 1e+09 MPa; no material is as stiff; if Pa are meant, give unit = "Pa"' ]] || show
  thesis_prior > thesis.toml
  exits 0 pf-weight draw thesis.toml -n 2 --tsv
  [[ -z $stderr ]] || show
}

@test "assimilate: options without effect and stations that no observation has are told" {
  pf-weight draw prior.toml -n 100 --tsv -o ensemble.h5 > sets.tsv
  local try=(ensemble.h5 observed.tsv --runs runs.tsv --variance 0.1)
  refuses 64 assimilate "--table runs: chooses the table that --tsv prints: give --tsv too, or leave it out" "${try[@]}" --table runs
  exits 0 pf-weight assimilate "${try[@]}" --at 50
  [[ $stderr == *"doubt: --at 50 lies outside of the observations, t from 1 to 5, and the nearest one counts instead"* ]] || show
  exits 0 pf-weight assimilate "${try[@]}" --until 500
  [[ $stderr == *'doubt: --until 500 lies far beyond the observations, t from 1 to 5, and leaves none out; if per cent are meant, write "500 %"'* ]] || show
  exits 0 pf-weight assimilate "${try[@]}" --until "500 %" --at 2,5
  [[ $stderr != *"--until 500"* && $stderr != *"--at"* ]] || show
  sed 's/^id/ID/' runs.tsv > named.tsv
  refuses 65 assimilate "named.tsv: no column id among ID, t, one, two" ensemble.h5 observed.tsv --runs named.tsv --variance 0.1
  pf-weight assimilate "${try[@]}" --quiet -o posterior.h5 > steps.txt
  refuses 64 resample "--components has no effect beside --method kernel: leave it out" posterior.h5 --method kernel --components 3 -o next.h5
}

@test "assimilate: columns of sets that the prior lacks are told where weights are" {
  pf-weight draw prior.toml -n 100 --tsv | awk -F '\t' '{ print $0 (NR == 1 ? "\tc" : "\t" NR) }' > sets.tsv
  exits 0 pf-weight assimilate sets.tsv observed.tsv --prior prior.toml --runs runs.tsv --variance 0.1 --quiet
  [[ $stderr == *"doubt: the sets differ in c, which the prior lacks: no weight tells which values fit; give the prior a [[parameter]] for each, or leave the columns out"* ]] || show
  exits 0 pf-weight assimilate sets.tsv observed.tsv --prior prior.toml --runs runs.tsv --variance 0.1 --quiet --tsv --table curves
  [[ $stderr != *"which the prior lacks"* ]] || show
}

# two A B: prints the linear model of the examples' runs for one parameter set.
@test "resample: weights that are all zero or negative are refused" {
  printf 'id\ta\tweight\n0\t1\t0\n1\t2\t0\n' > zero.tsv
  exits 65 pf-weight resample zero.tsv -n 4 -o out.h5
  [[ $stderr == "pf-weight resample: zero.tsv: all weights are zero: no set is left to go on from; assimilate again, with a larger --error" ]] ||
    show
  printf 'id\ta\tweight\n0\t1\t1.5\n1\t2\t-0.5\n' > negative.tsv
  exits 65 pf-weight resample negative.tsv -n 4 -o out.h5
  [[ $stderr == "pf-weight resample: negative.tsv: weight: row 2: -0.5 is negative; weights are 0 or more" ]] || show
}

@test "resample: rounds of 40 sets come to the parameters that the observations were made with" {
  # observed.tsv is made with a = 0.3, b = -0.4 and no noise: y = a + b t / 5, a t / 5 - b.
  local ensemble=ensemble.h5 round
  pf-weight draw prior.toml -n 40 --method sobol --first 1 -o ensemble.h5
  pf-weight draw prior.toml -n 40 --method sobol --first 1 --tsv > sets.tsv
  for round in 1 2 3; do
    awk -F '\t' 'BEGIN { print "id\tt\tone\ttwo" }
      NR > 1 { for (t = 1; t <= 5; ++t) printf "%d\t%d\t%.17g\t%.17g\n", $1, t, $2 + $3 * t / 5, $2 * t / 5 - $3 }' sets.tsv > runs.tsv
    pf-weight assimilate $ensemble observed.tsv --runs runs.tsv --variance 1e-2 --tsv --quiet -o "posterior$round.h5" > "steps$round.tsv"
    pf-weight resample "posterior$round.h5" -n 40 --seed "$round" --tsv --quiet -o "next$round.h5" > sets.tsv
    ensemble=next$round.h5
  done
  [[ $(sed -n 2p sets.tsv | cut -f 1) -eq 120 ]] || show "ids go on: $(sed -n 2p sets.tsv)"
  holds '(a - 0.3) ^ 2 < 0.05 ^ 2 && (b + 0.4) ^ 2 < 0.05 ^ 2 && size > 8' a="$(value steps3.tsv a last)" \
    b="$(value steps3.tsv b last)" size="$(value steps3.tsv effective_size last)"
  exits 0 pf-weight resample posterior3.h5 -n 5 --method kernel --tsv
  [[ ${lines[0]} == *log_importance* ]] || show
}

@test "resample --keep: sets of all rounds are one sample" {
  local ensemble=ensemble.h5 round kept
  pf-weight draw prior.toml -n 40 --method sobol --first 1 -o ensemble.h5
  pf-weight draw prior.toml -n 40 --method sobol --first 1 --tsv > sets.tsv
  echo $'id\tt\tone\ttwo' > runs.tsv
  for round in 1 2 3; do
    # Only the runs of the new sets are added.
    awk -F '\t' 'NR > 1 { for (t = 1; t <= 5; ++t) printf "%d\t%d\t%.17g\t%.17g\n", $1, t, $2 + $3 * t / 5, $2 * t / 5 - $3 }' \
      sets.tsv >> runs.tsv
    pf-weight assimilate $ensemble observed.tsv --runs runs.tsv --variance 1e-2 --tsv --quiet -o "posterior$round.h5" > "steps$round.tsv"
    pf-weight resample "posterior$round.h5" -n 40 --seed "$round" --keep --tsv --quiet -o "next$round.h5" > sets.tsv
    [[ $(wc -l < sets.tsv) -eq 41 && $(sed -n 2p sets.tsv | cut -f 1) -eq $((40 * round)) ]] || show "new sets alone: $(head -n 2 sets.tsv)"
    ensemble=next$round.h5
  done
  kept=$(pf-weight assimilate next2.h5 observed.tsv --runs runs.tsv --variance 1e-2 --tsv --table weights --quiet | wc -l)
  [[ $kept -eq 121 ]] || show "three rounds of 40: $kept"
  holds '(a - 0.3) ^ 2 < 0.05 ^ 2 && (b + 0.4) ^ 2 < 0.05 ^ 2 && size > 10' a="$(value steps3.tsv a last)" \
    b="$(value steps3.tsv b last)" size="$(value steps3.tsv effective_size last)"
  # A table does not hold the densities that its sets were drawn from.
  pf-weight resample posterior1.h5 -n 20 --seed 9 --tsv --quiet > alone.tsv
  awk -F '\t' 'BEGIN { print "id\tt\tone\ttwo" } NR > 1 { for (t = 1; t <= 5; ++t) print $1 "\t" t "\t" $2 "\t" $3 }' alone.tsv > alone_runs.tsv
  pf-weight assimilate alone.tsv observed.tsv --prior prior.toml --runs alone_runs.tsv --variance 1e-2 --quiet -o alone.h5 > /dev/null
  refuses 65 resample "alone.h5: does not record the distribution of its sets; draw them anew, or resample without --keep" \
    alone.h5 -n 5 --keep --tsv -o next_alone.h5
  refuses 64 resample "--keep has no effect without -o, for --tsv prints the new sets: leave it out" alone.h5 -n 5 --keep --tsv
}

@test "2000 sets and 100 steps of three observables take less than a second" {
  [[ $BIN == */build/bin ]] || skip "not the build that users have"
  thesis_prior > thesis.toml
  pf-weight draw thesis.toml -n 2000 -o ensemble.h5
  awk 'BEGIN { srand(1); print "id\tt\tone\ttwo\tthree"; for (i = 0; i < 2000; ++i) { a = rand()
    for (t = 1; t <= 100; ++t) printf "%d\t%d\t%.6g\t%.6g\t%.6g\n", i, t, a * t, a + t, a * a * t } }' > runs.tsv
  awk 'BEGIN { print "t\tone\ttwo\tthree"; for (t = 1; t <= 100; ++t) printf "%d\t%.6g\t%.6g\t%.6g\n", t, t / 2, t + 0.5, t / 4 }' > observed.tsv
  local seconds TIMEFORMAT=%U
  seconds=$({ time pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --variance 0.1 --quiet -o posterior.h5 > /dev/null 2> said.txt; } 2>&1)
  echo "# $seconds s" >&3
  holds 's < 1' s="$seconds"
}

@test "each verb has help that fits a screen, a page, and examples that run" {
  local verb command
  pf-weight draw prior.toml --samples 100 --tsv > sets.tsv
  for verb in draw assimilate resample; do
    exits 0 pf-weight "$verb" --help
    [[ $(wc -l <<<"$output") -le 40 && $(wc -L <<<"$output") -le 100 ]] || show "$verb --help is too large: $(wc -l <<<"$output")"
    local examples=0
    while IFS= read -r command; do
      [[ $command == *" -o "* ]] && command+=" --force"
      exits 0 bash -c "set -o pipefail; $command" || show "example of $verb: $command"
      examples=$((examples + 1))
    done < <(awk '/^[A-Z]/ { on = /^Example/ } on && /^  [^ ]/ { sub(/^  /, ""); print }' <<<"$output")
    ((examples > 0)) || show "$verb --help has no example"
    exits 0 pf-weight "$verb" --man
    [[ ${lines[0]} == ".TH pf\\-weight\\-$verb 1 "* ]] || show "$verb --man"
  done
  complains 64 pf-weight "a verb is missing; give one of draw, assimilate, resample, or see 'pf-weight --help'"
}
