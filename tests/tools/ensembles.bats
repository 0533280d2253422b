#!/usr/bin/env bats
# Ensembles of runs: stopped ones go on and end in the same bytes, failed rows are reported, changed inputs run anew.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

ROOT=$BATS_TEST_DIRNAME/../..

setup() {
  cd "$BATS_TEST_TMPDIR" || return
  command -v parallel >/dev/null || skip "GNU parallel is not installed"
}

# Runs the studies' rules with the real tools, in a folder of the test's own, on a small ensemble.
study() { # OUT TARGET...
  local out=$1
  shift
  study_rules BIN="$BIN" OUT="$out" C2_CASES=hm_200_0.2 C2_SAMPLES="6 4" C2_STRAIN=0.5 "$@"
}

@test "an ensemble that is killed three times ends in the same bytes as one that is not" {
  local whole=$PWD/whole killed=$PWD/killed posterior=ch2/hm_200_0.2/posterior.h5 k
  export JOBS=2 PROGRESS_INTERVAL=0
  exits 0 study "$whole" "$whole/$posterior"
  for k in 1 2 3; do
    set -m
    study "$killed" "$killed/$posterior" > "make$k.log" 2>&1 &
    local make=$!
    set +m
    sleep "$((RANDOM % 2)).$((RANDOM % 900 + 100))"
    # Kills twice everything that make started, whatever its process group, and once make alone, whose jobs live on.
    if ((k < 3)); then family "$make" | xargs -r kill -KILL || true; else kill -KILL "$make" || true; fi
    wait "$make" || true
  done 2>/dev/null
  exits 0 study "$killed" "$killed/$posterior"
  same_bytes "$whole/$posterior" "$killed/$posterior"
  exits 0 study "$killed" "$killed/$posterior"
  [[ $output != *"  run  "* ]] || show "a finished ensemble ran again"
}

# family PID: prints the process and all its descendants.
family() {
  local child
  for child in $(pgrep -P "$1"); do family "$child"; done
  echo "$1"
}

# ensemble TABLE: runs it on a small packing, into the folder `case`.
ensemble() {
  "$ROOT/pipelines/calibration/ensemble.sh" "$1" case hm packing.h5 scenario.toml 0.1 0.4
}

small_inputs() {
  pack-generate --grains 200 --pressure 1e4 --void-ratio 0.8 --seed 1 --quiet -o packing.h5
  cp "$ROOT/pipelines/calibration/hertz-mindlin.toml" scenario.toml
  printf 'id [1]\tE [Pa]\tnu [1]\tkr [1]\teta [1]\tmu [deg]\n%s\n%s\n%s\n' $'0\t4e9\t0.2\t0.1\t0.2\t30' $'1\t1e3\t0.2\t0.1\t0.2\t30' \
    $'2\t4e9\t0.2\t0.1\t0\t25' > sets.tsv
}

@test "rows that fail each time are listed with the reason and not run again; lost rows are" {
  small_inputs
  exits 0 ensemble sets.tsv
  [[ $output == *"case sets: rows that failed, with the reason:"*"1: run-dem:"* ]] || show
  [[ $output =~ "case sets: 3 runs, 1 failed, "[0-9]+" runs per hour and core" ]] || show
  [[ -e case/runs/000000/series.h5 && -e case/runs/000002/series.h5 && -e case/runs/000001/failed ]] || show
  local before
  before=$(stat -c %Y.%i case/runs/*/series.h5)
  exits 0 ensemble sets.tsv
  [[ $before == "$(stat -c %Y.%i case/runs/*/series.h5)" ]] || show "rows ran again"
  rm -r case/runs/000002
  printf '3\tlocalhost\t17' >> case/sets.joblog
  exits 0 ensemble sets.tsv
  [[ $output == *"1 of 3 rows"* && -e case/runs/000002/series.h5 ]] || show "a lost row did not run again"
  sed -i '$ s/25$/26/' sets.tsv
  exits 0 ensemble sets.tsv
  [[ $output == *"1 of 3 rows"* ]] || show "a row with other parameters did not run again"
  printf '# changed\n' >> scenario.toml
  exits 0 ensemble sets.tsv
  [[ $output == *"3 of 3 rows"* ]] || show "a changed scenario did not run all rows again"
}

@test "any other trouble stops the study, with the rows that are missing" {
  small_inputs
  mkdir tools
  ln -s "$BIN"/* tools
  rm tools/run-dem
  printf '#!/bin/sh\necho "run-dem: disk full" >&2\nexit 74\n' > tools/run-dem
  chmod +x tools/run-dem
  BIN=$PWD/tools exits 1 ensemble sets.tsv
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $stderr == *"case: 3 rows did not finish (see case/sets.joblog); make again tries them"* ]] || show
  [[ $stderr == *"run-dem: disk full"* ]] || show
  exits 0 ensemble sets.tsv
}

@test "folders and packings may have any name, tables any line ends, ids leading zeros" {
  small_inputs
  # shellcheck disable=SC2016  # the dollar is part of the name
  local packing=$'a b;$(touch pwned)\'".h5' folder=' bl ank={1}=$(touch pwned)'
  mv packing.h5 "$packing"
  printf '\xef\xbb\xbfid [1]\tE [Pa]\tnu [1]\tkr [1]\teta [1]\tmu [deg]\r\n000008\t4e9\t0.2\t0.1\t0.2\t30\r\n000010\t4e9\t0.2\t0.1\t0\t25' > sets.tsv
  exits 0 "$ROOT/pipelines/calibration/ensemble.sh" sets.tsv "$folder" hm "$packing" scenario.toml 0.1 0.1
  [[ $output == *"2 of 2 rows"*"2 runs, 0 failed"* ]] || show
  [[ -e $folder/runs/000008/series.h5 && -e $folder/runs/000010/series.h5 && ! -e pwned ]] || show "$(find .)"
  [[ $(cat "$folder/runs/000010/parameters") == "hm 0.1 0.1 4e9 0.2 0.1 0 25 0" ]] || show "$(cat "$folder"/runs/*/parameters)"
  exits 0 "$ROOT/pipelines/calibration/ensemble.sh" sets.tsv "$folder" hm "$packing" scenario.toml 0.1 0.1
  [[ $output != *"  run  "* ]] || show "a finished ensemble ran again"
  exits 65 "$ROOT/pipelines/calibration/ensemble.sh" sets.tsv $'ta\tb' hm "$packing" scenario.toml 0.1 0.1
  [[ $stderr == "jobs: ta"$'\t'"b: names of folders and files may not hold tabs or line ends" ]] || show
}

@test "a table may number twins, whose grains start elsewhere; inputs that are missing are named" {
  small_inputs
  printf 'id\tkr\tE\tnu\teta\tmu\tlog_importance\ttwin\n0\t0.1\t4e9\t0.2\t0.2\t30\t-1\t0\n1\t0.1\t4e9\t0.2\t0.2\t30\t-1\t1\n' > sets.tsv
  exits 0 ensemble sets.tsv
  [[ $(cat case/runs/000001/parameters) == "hm 0.1 0.4 4e9 0.2 0.1 0.2 30 1" ]] || show "$(cat case/runs/*/parameters)"
  ! cmp -s case/runs/00000[01]/series.h5 || show "the twin is the packing itself"
  rm scenario.toml
  exits 66 ensemble sets.tsv
  [[ $stderr == "ensemble: scenario.toml: cannot be read: No such file or directory" ]] || show
  exits 66 ensemble none.tsv
  [[ $stderr == "rows: none.tsv: cannot be read: No such file or directory" ]] || show
}

@test "rows go to the hosts of SSHLOGINFILE, names unharmed" {
  small_inputs
  # Replaces ssh HOST -- COMMAND, and runs the command here.
  cat > hop <<'SH'
#!/bin/sh
echo "$1" >> "${0%/*}/called"
shift
[ "$1" != -- ] || shift
export SHELL=/bin/sh
exec sh -c "$*"
SH
  chmod +x hop
  printf '1/%s host1\n1/%s host2\n' "$PWD/hop" "$PWD/hop" > hosts
  SSHLOGINFILE=$PWD/hosts JOBS=1 exits 0 "$ROOT/pipelines/calibration/ensemble.sh" sets.tsv "bl ank \$x" hm packing.h5 scenario.toml 0.1 0.2
  [[ -e "bl ank \$x/runs/000002/series.h5" && $(sort -u called | tr '\n' ' ') == "host1 host2 " ]] || show "$(cat called)"
}

@test "ENGINE=slurm: rows are an array job, which an interrupted make takes along" {
  small_inputs
  mkdir slurm
  # Replaces sbatch: the job runs at once, one task after another, and is over when squeue is asked.
  cat > slurm/sbatch <<'SH'
#!/bin/sh
for word; do case $before in --array) last=${word#0-} ;; --wrap) job=$word ;; esac; before=$word; done
[ -z "${STUCK:-}" ] || last=-1
for k in $(seq 0 "$last"); do SLURM_ARRAY_TASK_ID=$k sh -c "$job" >&2; done
echo "7;cluster"
SH
  cat > slurm/squeue <<'SH'
#!/bin/sh
: > asked
printf %s "${STUCK:-}"
SH
  printf '#!/bin/sh\necho "$*" > cancelled\n' > slurm/scancel
  chmod +x slurm/*
  export PATH=$PWD/slurm:$PATH ENGINE=slurm SLURM_POLL=0.1 SLURM_ARRAY_SIZE=2
  exits 0 "$ROOT/pipelines/calibration/ensemble.sh" sets.tsv 'bl ank' hm packing.h5 scenario.toml 0.1 0.2
  [[ $output == *"3 of 3 rows"*"3 runs, 1 failed"* && -e "bl ank/runs/000002/series.h5" ]] || show
  # Where Slurm does not answer, the job may still be running, and is asked for again.
  mv slurm/squeue slurm/answering
  cat > slurm/squeue <<'SH'
#!/bin/sh
printf . >> times
[ "$(cat times)" = . ] || exit 0
echo "Socket timed out on send/recv operation" >&2
exit 1
SH
  chmod +x slurm/squeue
  exits 0 "$ROOT/pipelines/calibration/ensemble.sh" sets.tsv third hm packing.h5 scenario.toml 0.1 0.2
  [[ $(cat times) == .. ]] || show "$(cat times)"
  mv slurm/answering slurm/squeue
  rm asked
  STUCK=7_1 "$ROOT/pipelines/calibration/ensemble.sh" sets.tsv other hm packing.h5 scenario.toml 0.1 0.2 3>&- &
  local job=$! k
  for k in $(seq 200); do [[ -e asked ]] && break; sleep 0.1; done
  kill "$job"
  wait "$job" || [[ $? -eq 143 ]]
  [[ $(cat cancelled) == 7 ]] || show "the job went on"
}

@test "tables that are not understood are refused by line, before any row runs" {
  local head=$'id [1]\tE [Pa]\tnu [1]\tkr [1]\teta [1]\tmu [deg]'
  : > packing.h5
  : > scenario.toml
  refuses_table() { # WORDS TABLE
    printf '%s\n' "$2" > sets.tsv
    call ensemble sets.tsv
    [[ $status -eq 65 && $stderr == "rows: sets.tsv: $1"* && -z $(find case/runs -name 'parameters') ]] || show "wanted $1"
  }
  refuses_table 'line 2: id "8x" is no whole number' "$head"$'\n8x\t4e9\t0.2\t0.1\t0.2\t30'
  refuses_table 'line 2: 2 values where the header names 6 columns' "$head"$'\n8\t4e9'
  refuses_table 'line 2: "0,2" in column 3 is no number; write it with a decimal point' "$head"$'\n8\t4e9\t0,2\t0.1\t0.2\t30'
  refuses_table 'line 3: id 8 is there twice' "$head"$'\n8\t4e9\t0.2\t0.1\t0.2\t30\n08\t4e9\t0.2\t0.1\t0.2\t30'
  refuses_table 'line 1: the first column is "id,E" where id belongs' $'id,E\n1,2'
  refuses_table 'line 1: 0 columns named nu or poisson_ratio where one belongs' $'id\tE\n1\t2'
  refuses_table 'line 1: 2 columns named mu or friction_angle where one belongs' "$head"$'\tfriction_angle\n'
  refuses_table 'line 1: mu is in rad: give it in deg' "${head/deg/rad}"
  refuses_table 'no rows below the header' "$head"
  exits 64 "$ROOT/pipelines/calibration/ensemble.sh" sets.tsv case lin packing.h5 scenario.toml 0.1 0.4
  [[ $stderr == 'ensemble: "lin" is no law; give hm (Hertz-Mindlin) or cl (linear)' ]] || show
  exits 64 "$ROOT/pipelines/calibration/ensemble.sh" sets.tsv case hm packing.h5 scenario.toml 0,1 0.4
  [[ $stderr == 'ensemble: PRESSURE_MPa: "0,1" is no number'* ]] || show
}
