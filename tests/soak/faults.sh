#!/bin/bash
# A short run killed at hundreds of random moments, and on a disk that fails at every call: never an unreadable file, never
# a lost checkpoint, always the same bytes in the end. tests/tools/checkpoints.bats asks it of a few moments.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: BIN=build/bin [KILLS=200] [STOPS=20] tests/soak/faults.sh
set -euo pipefail
export LC_ALL=C.UTF-8
BIN=$(cd "${BIN:-build/bin}" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() {
  echo "tests/soak/faults.sh: $*" >&2
  [[ ! -e said ]] || cat said >&2
  exit 1
}

cat "$here/../tools/sand.toml" - > short.toml << 'TOML'
[contact.rolling]
stiffness = 0.13
limit = 0.3

[equilibrium]
unbalanced_force = 1e-2

[record]
snapshots = "stations"

[[stage]]
path = "triaxial"
confining_pressure = "100 kPa"
axial_strain = 0.02
increment = 0.002
rate = 0.2
TOML
"$BIN/pack-generate" --quiet --grains 200 --aspect 1 --pressure 1e5 --tolerance 1e-2 -o packing.h5
run=("$BIN/run-dem" --quiet --checkpoint-every 0.005 packing.h5 short.toml)
"${run[@]}" -o whole.h5
seconds=$( { TIMEFORMAT=%R; time "${run[@]}" -o timed.h5; } 2>&1)

# Every file of a run under way can be read, whenever it was killed.
readable() {
  local file
  for file in out.h5.part/*.h5; do
    [[ ! -e $file ]] || "$BIN/homogenize" --quiet --tsv "$file" > table || fail "$file cannot be read"
  done
}

# interrupted SIGNAL: makes one attempt and sends it the signal after a random part of a whole run's time.
interrupted() {
  local status=0
  "${run[@]}" --resume -o out.h5 2> said &
  local process=$!
  sleep "$(awk -v s="$seconds" -v r="$RANDOM" 'BEGIN { printf "%.4f", 0.4 * s * r / 32768 }')"
  kill -s "$1" $process 2> killed || true
  { wait $process || status=$?; } 2> killed
  case $status in
    0) # It was faster: begin again.
      cmp -s whole.h5 out.h5 || fail "other bytes after $1"
      rm out.h5
      ends=$((ends + 1))
      ;;
    75 | 137 | 143) readable ;;
    *) fail "status $status after $1" ;;
  esac
}

ends=0
for ((n = 0; n < ${KILLS:-200}; ++n)); do interrupted KILL; done
echo "killed $n times, $ends runs ended on the way, all with the same bytes"
ends=0
for ((n = 0; n < ${STOPS:-20}; ++n)); do
  if ((RANDOM % 2)); then interrupted TERM; else interrupted KILL; fi
done
echo "stopped or killed $n times, $ends runs ended on the way, all with the same bytes"
"${run[@]}" --resume -o out.h5
cmp whole.h5 out.h5 || fail "other bytes in the end"

"${CC:-cc}" -shared -fPIC -O1 "$here/../tools/faults.c" -o faults.so -ldl
faults=0
for call in write fsync rename; do
  for ((at = 1; at < 1000; ++at)); do
    rm -rf out.h5 out.h5.part
    status=0
    LD_PRELOAD=$folder/faults.so FAULT=$call FAULT_AT=$at "${run[@]}" --checkpoint-every 0 -o out.h5 2> said || status=$?
    [[ $status -ne 0 ]] || break
    [[ $status -eq 73 || $status -eq 74 ]] || fail "$call $at: status $status"
    [[ ! -e out.h5 ]] || cmp -s whole.h5 out.h5 || fail "$call $at: half an output"
    readable
    "${run[@]}" --resume -o out.h5
    cmp -s whole.h5 out.h5 || fail "$call $at: other bytes"
    faults=$((faults + 1))
  done
done
echo "$faults calls failed, at every write, sync and rename of a run; all went on to the same bytes"
