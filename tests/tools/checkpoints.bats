#!/usr/bin/env bats
# Work is never lost: runs killed at any moment, on a full disk or with the folder gone, go on to the same bytes, or say
# what is left. tests/soak/faults.sh asks the same of hundreds of moments.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup_file() {
  load common
  cd "$BATS_FILE_TMPDIR" || return
  cat "$BATS_TEST_DIRNAME/sand.toml" - > short.toml << 'TOML'
restitution = 0.8

[contact.rolling]
stiffness = 0.13
limit = 0.3

[equilibrium]
unbalanced_force = 1e-2

[record]
snapshots = "list"
strains = [0.002, 0.003]

[[stage]]
path = "isotropic"
pressure = "100 kPa"

[[stage]]
path = "triaxial"
confining_pressure = "100 kPa"
axial_strain = 0.004
increment = 0.001
rate = 0.5
way_unbalanced_force = 0.02
friction_angle = 25
damping = 0.15
reset_strain = true
TOML
  pack-generate --quiet --grains 60 --aspect 1 --pressure 1e5 --tolerance 1e-2 -o packing.h5
  run-dem --quiet packing.h5 short.toml -o run.h5
  "${CC:-cc}" -shared -fPIC -O1 "$BATS_TEST_DIRNAME/faults.c" -o faults.so -ldl
}

setup() {
  mkdir "$BATS_TEST_TMPDIR/here"
  cd "$BATS_TEST_TMPDIR/here" || return
  ln -s "$BATS_FILE_TMPDIR"/* .
}

# short ARGUMENTS...: runs the reference run with frequent checkpoints.
short() {
  run-dem --quiet --checkpoint-every 0.002 packing.h5 short.toml "$@"
}

# broken CALL AT COMMAND...: runs the command with this system call failing from the AT-th on.
broken() {
  LD_PRELOAD=$PWD/faults.so FAULT=$1 FAULT_AT=$2 "${@:3}"
}

# stopped SIGNAL SECONDS: sends the run the signal after this time; $status is its exit status.
stopped() {
  env --default-signal run-dem --quiet --checkpoint-every 0.002 packing.h5 short.toml --resume -o out.h5 2> said &
  local run=$!
  sleep "$2"
  kill -s "$1" $run 2> killed || true
  status=0
  wait $run || status=$?
}

# Starts a run that does not end while a test looks on; $run is its process.
begin_long() {
  run-dem --quiet --checkpoint-every 0.02 packing.h5 short.toml --set stage.1.rate=1e-6 -o out.h5 2> said &
  run=$!
  for _ in {1..500}; do
    compgen -G 'out.h5.part/checkpoint-*' > list && return
    sleep 0.02
  done
  show "no checkpoint after ten seconds"
}

@test "stopped by any signal at any moment a run goes on to the same bytes" {
  local signal stops=0
  for signal in TERM KILL INT HUP XCPU KILL TERM KILL; do
    stopped "$signal" "0.0$((RANDOM % 5))$((RANDOM % 10))"
    case $status in
      0) break ;;
      75)
        stops=$((stops + 1))
        grep -qx "run-dem: stopped by SIG$signal after step [0-9]*; out.h5.part/[a-z]*-[0-9]*.h5 is whole: the same \
command with --resume goes on from there" said || show "$(< said)"
        ;;
      137 | 143 | 130 | 129 | 152) ;; # killed, or before it listened
      *) show "status $status: $(< said)" ;;
    esac
  done
  short --resume -o out.h5
  same_bytes run.h5 out.h5
  [[ ! -e out.h5.part ]] || show "the folder is still there"
}

@test "a run under way is read from its folder: the series so far, the recorded states and the newest" {
  begin_long
  exits 0 homogenize --quiet --tsv --table series out.h5.part
  printf '%s\n' "$output" > so_far.tsv
  exits 0 homogenize --quiet --tsv --columns step out.h5.part/
  printf '%s\n' "$output" > states.tsv
  exits 0 to-vtk --history out.h5.part
  [[ $output == *"run-dem"* ]] || show "history"
  kill -s TERM $run
  wait $run || true
  homogenize --quiet --tsv --table series run.h5 > whole.tsv
  same_bytes so_far.tsv <(head -n "$(wc -l < so_far.tsv)" whole.tsv)
  [[ $(wc -l < so_far.tsv) -gt 2 && $(wc -l < states.tsv) -gt 1 ]] || show "$(cat so_far.tsv states.tsv)"
  mkdir empty.h5.part
  mentions 66 homogenize "holds no state yet" --tsv empty.h5.part
  mkdir folder
  mentions 65 homogenize "folder" --tsv folder
}

@test "SIGTERM: the step is finished, a checkpoint written, status 75" {
  begin_long
  kill -s TERM $run
  status=0
  wait $run || status=$?
  [[ $status -eq 75 ]] || show "status $status: $(< said)"
  local step
  step=$(sed -n 's/.*after step \([0-9]*\);.*/\1/p' said)
  [[ -e out.h5.part/checkpoint-$(printf %012d "$step").h5 ]] || show "no checkpoint of step $step"
}

@test "the limit of processor time is obeyed like SIGTERM" {
  call bash -c 'ulimit -S -t 1; exec run-dem --quiet packing.h5 short.toml --set stage.1.rate=1e-6 -o out.h5'
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $status -eq 75 && $stderr == *"stopped by SIGXCPU"* ]] || show "not stopped by SIGXCPU"
}

@test "what the caller ignores is ignored" {
  (
    trap '' HUP
    exec run-dem --quiet --checkpoint-every 0.002 packing.h5 short.toml -o out.h5
  ) &
  sleep 0.02
  kill -s HUP $! || true
  wait $!
  same_bytes run.h5 out.h5
}

@test "threads change nothing: 1, 2, 3 and 16, and another number after every stop" {
  local n
  for n in 1 2 3 16; do
    run-dem --quiet --threads $n packing.h5 short.toml -o $n.h5
    same_bytes run.h5 $n.h5
  done
  for n in 1 2 3; do
    timeout -s TERM 0.06 run-dem --quiet --threads $n packing.h5 short.toml --resume -o out.h5 2> said || true
  done
  run-dem --quiet --threads 2 packing.h5 short.toml --resume -o out.h5
  same_bytes run.h5 out.h5
}

@test "a disk that fills up, a sync or a rename that fails, at each of them: nothing is lost" {
  local call at said
  for call in write fsync rename; do
    for at in {1..40}; do
      call broken $call "$at" run-dem --quiet packing.h5 short.toml -o out.h5
      [[ $status -ne 0 ]] || break
      [[ $status -eq 73 || $status -eq 74 ]] || show "$call $at"
      said=$(without_doubts)
      [[ $said == "run-dem: "* && $said != *$'\n'* ]] || show "$call $at: wanted one line"
      if compgen -G 'out.h5.part/state-*' > list; then
        [[ $stderr == *"is whole: the same command with --resume goes on from there" ]] || show "$call $at: no way on"
      fi
      [[ ! -e out.h5 ]] || same_bytes run.h5 out.h5 # renamed, but its folder was not synced
      run-dem --quiet packing.h5 short.toml --resume -o out.h5
      same_bytes run.h5 out.h5
      rm -rf out.h5 out.h5.part
    done
    ((at > 5 && at < 40)) || show "$call: failed $at times"
    rm -rf out.h5 out.h5.part
  done
  call broken mkdir 1 run-dem --quiet packing.h5 short.toml -o out.h5
  [[ $status -eq 73 && $stderr == "run-dem: out.h5: cannot be created: "* ]] || show "no folder"
}

@test "a folder that is removed under way: the message says that it is gone" {
  begin_long
  # The run may write into the folder while it is emptied.
  until rm -rf out.h5.part; do :; done
  status=0
  wait $run || status=$?
  [[ $status -eq 73 || $status -eq 74 ]] || show "status $status: $(< said)"
  grep -q "out.h5.part is gone, and with it the record: run it again" said || show "$(< said)"
}

@test "a checkpoint that is damaged is passed over for the one before" {
  begin_long
  kill -s TERM $run
  wait $run || true
  local files=(out.h5.part/*-*.h5)
  [[ ${#files[@]} -ge 3 ]] || show "wanted two checkpoints and a state"
  local last
  last=$(find out.h5.part -name '*-*.h5' -printf '%f\n' | sort -t - -k 2 | tail -1)
  truncate -s 1000 "out.h5.part/$last"
  mentions 65 run-dem "whose options differs" --quiet packing.h5 short.toml --resume -o out.h5
  call timeout -s TERM 3 run-dem packing.h5 short.toml --set stage.1.rate=1e-6 --resume -o out.h5
  [[ $stderr == *"going on from out.h5.part/checkpoint-"* && $stderr != *"going on from out.h5.part/$last"* ]] || show
}

@test "--resume without anything to go on from begins; of a finished run it does nothing" {
  exits 0 run-dem packing.h5 short.toml --resume -o out.h5
  [[ $stderr == *"run-dem: out.h5.part does not exist; beginning anew"* ]] || show "wanted a note"
  same_bytes run.h5 out.h5
  mkdir empty.h5.part
  exits 0 run-dem packing.h5 short.toml --resume -o empty.h5
  [[ $stderr == *"run-dem: empty.h5.part holds nothing to go on from; beginning anew"* ]] || show "wanted a note"
  same_bytes run.h5 empty.h5
  exits 0 run-dem packing.h5 short.toml --resume -o out.h5
  [[ $stderr == "run-dem: out.h5 is finished already" ]] || show "wanted a note"
  mkdir out.h5.part # left by a crash at the very end
  exits 0 run-dem --quiet packing.h5 short.toml --resume -o out.h5
  same_bytes run.h5 out.h5
  [[ ! -e out.h5.part ]] || show "the folder is still there"
  refuses 73 run-dem "out.h5: exists, of a run whose options differs; give --force" --quiet packing.h5 short.toml \
    --resume --set numerics.damping=0.3 -o out.h5
}

@test "an unfinished run is neither overwritten nor mixed with another" {
  begin_long
  mentions 73 run-dem "another process is at work on this run" --quiet packing.h5 short.toml --resume -o out.h5
  kill -s TERM $run
  wait $run || true
  local same=(--quiet packing.h5 short.toml --set stage.1.rate=1e-6 -o out.h5)
  refuses 73 run-dem "holds an unfinished run, at step" "${same[@]}"
  refuses 65 run-dem "whose seed differs" "${same[@]}" --resume --perturb 1e-6 --seed 3
  refuses 65 run-dem "whose options differs" "${same[@]}" --resume --set numerics.damping=0.1
  sed 's/0.15/0.16/' short.toml > other.toml
  refuses 65 run-dem "whose scenario differs" "${same[@]/short.toml/other.toml}" --resume
  pack-generate --quiet --grains 60 --aspect 1 --pressure 1e5 --tolerance 1e-2 --seed 1 -o other.h5
  refuses 65 run-dem "whose packing differs" "${same[@]/packing.h5/other.h5}" --resume
  exits 0 run-dem packing.h5 short.toml --resume --force -o out.h5
  [[ $stderr == *"run-dem: out.h5.part held another run, which --force gives up; beginning anew"* ]] || show "wanted a note"
  same_bytes run.h5 out.h5
}

@test "pack-generate goes on to the same bytes" {
  local generate=(pack-generate --quiet --grains 100 --aspect 1 --pressure 1e5 --void-ratio 0.72 --tolerance 1e-2 --seed 1)
  "${generate[@]}" -o whole.h5
  local n
  for n in 1 2 3 4; do
    timeout -s $((n % 2 ? 15 : 9)) "0.0$((RANDOM % 6 + 3))" "${generate[@]}" --checkpoint-every 0.01 --resume -o out.h5 \
      2> said || true
  done
  "${generate[@]}" --resume -o out.h5
  same_bytes whole.h5 out.h5
}

@test "every run tells its cost, and --check predicts it" {
  exits 0 run-dem packing.h5 short.toml -o out.h5
  local words='steps ([0-9]* % of them waiting for rest) of 60 grains with [0-9]* contacts in [0-9.e+]* s: [0-9.e+]* steps/s, [0-9.e+]* ns per contact; '
  words+='contacts [0-9]* %, integration [0-9]* %, neighbours [0-9]* %, output [0-9]* %'
  grep -qx "run-dem: [0-9]* $words" <<< "$stderr" || show "wanted the cost"
  local steps
  steps=$(grep -v ': doubt: ' <<< "$stderr")
  steps=${steps#run-dem: }
  steps=${steps%% *}
  [[ $(h5dump -d /price/steps out.h5) == *"(0): $steps"* ]] || show "the file says another number of steps"
  rm out.h5
  refuses 64 run-dem "--output is missing" packing.h5 short.toml
  exits 0 run-dem --check packing.h5 short.toml
  [[ $(here) != *out.h5* ]] && ! grep -v ': doubt: ' <<< "$stderr" | grep -q . || show "wanted nothing but text"
  grep -q '^stage "triaxial": 4 stations, about [0-9.e+]* steps ([0-9.e+]* to [0-9.e+]*, slowed down on the way), [0-9.e+]* of them waiting for rest$' <<< "$output" || show "no stages"
  grep -Eq '^time step [0-9.e-]+ s, stability limit [0-9.e-]+ s$' <<< "$output" || show "no time step"
  grep -Eq '^5 states recorded, file about [0-9.]+ kB, memory about [0-9.]+ MB$' <<< "$output" || show "no sizes"
  local predicted
  predicted=$(sed -n "s|^about [0-9.e+]* [a-z]* ([0-9.e+]* [a-z]* to [0-9.e+]* [a-z]*): \([0-9]*\) $words\$|\1|p" <<< "$output")
  # The time until grains rest is not known beforehand, but its order of magnitude is.
  ((predicted > steps / 4 && predicted < steps * 4)) || show "predicted $predicted of $steps steps"
  exits 0 run-dem --check packing.h5 short.toml --set stage.1.way_unbalanced_force=0
  [[ $output == *'stage "triaxial": 4 stations, about '* && $output != *'slowed down'* ]] || show "wanted a guess, for nothing is paced"
  exits 65 run-dem --check packing.h5 short.toml --set numerics.dampng=1
}

@test "a checkpoint that was edited is refused with a remedy that works" {
  "$PYTHON" -c 'import h5py' || skip "no Python with h5py"
  begin_long
  kill -s TERM $run
  wait $run || true
  cp -r out.h5.part kept
  local value words
  while read -r value words; do
    rm -rf out.h5.part
    cp -r kept out.h5.part
    "$PYTHON" -c "
import glob, h5py
for name in glob.glob('out.h5.part/*.h5'): h5py.File(name, 'r+')['checkpoint/stage'][...] = float('$value')"
    mentions 65 run-dem "$words" --quiet packing.h5 short.toml --set stage.1.rate=1e-6 --resume -o out.h5
    [[ $stderr == *"give --force without --resume to begin anew" ]] || show "no remedy"
  done << 'CASES'
99 keeps a stage that this run cannot have
-1 keeps a stage that this run cannot have
0.5 keeps a stage of 0.5, which is no whole number
nan keeps a stage that is not a number
1e300 which is no whole number
CASES
  timeout --preserve-status -s TERM 1 run-dem --quiet packing.h5 short.toml --set stage.1.rate=1e-6 --force -o out.h5 2> said || status=$?
  [[ $status -eq 75 ]] || show "status $status: $(< said)"
}
