# shellcheck shell=bash
# Common parts of the tool tests: the tools on PATH, a folder of its own for each test, and assertions that say what they saw.
# SPDX-License-Identifier: GPL-3.0-or-later
bats_require_minimum_version 1.5.0

BIN=$(cd "${BIN:-${BASH_SOURCE[0]%/*}/../../build/bin}" && pwd)
export BIN PATH="$BIN:$PATH" LC_ALL=C.UTF-8
# Threads that wait for each other sleep: tests take more threads than there are cores, beside other tests, and would take most of
# their time to wait for one that does not run.
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}
# Debian's own interpreter has the HDF5 and VTK modules that the tests use.
export PYTHON=${PYTHON:-/usr/bin/python3}

# call COMMAND...: runs it; afterwards $status, $output (standard output), its $lines, and $stderr are set. bats' own run takes
# twice as long.
call() {
  local options=$-
  set +eET
  output=$("$@" 2> "$BATS_TEST_TMPDIR/said") && status=0 || status=$?
  stderr=$(< "$BATS_TEST_TMPDIR/said")
  # shellcheck disable=SC2034  # tests read it
  mapfile -t lines <<< "$output"
  set "-$options"
}

show() {
  printf 'status: %s\nstdout: %s\nstderr: %s\n' "${status:-}" "${output:-}" "${stderr:-}" >&2
  printf '%s\n' "$@" >&2
  return 1
}

# exits STATUS COMMAND...: runs the command and demands the exit status.
exits() {
  local wanted=$1
  shift
  call "$@"
  # shellcheck disable=SC2154  # call sets it
  [[ $status -eq $wanted ]] || show "wanted exit status $wanted of: $*"
}

# complains STATUS TOOL MESSAGE ARGUMENTS...: exactly one line, "TOOL: MESSAGE", and nothing on standard output.
complains() {
  local wanted=$1 tool=$2 message=$3
  shift 3
  call "$tool" "$@"
  [[ $status -eq $wanted ]] || { show "wanted exit status $wanted of: $tool $*"; return 1; }
  [[ $stderr == "$tool: $message" ]] || { show "wanted: $tool: $message"; return 1; }
  [[ -z $output ]] || show "wanted nothing on standard output"
}

# without_doubts: what was said on standard error beside doubts, which are told of the small packings of tests.
without_doubts() {
  grep -v ': doubt: ' <<< "$stderr" || true
}

# mentions STATUS TOOL WORDS ARGUMENTS...: demands one line that starts with the tool's name and contains the words.
mentions() {
  local wanted=$1 tool=$2 words=$3
  shift 3
  call "$tool" "$@"
  [[ $status -eq $wanted ]] || { show "wanted exit status $wanted of: $tool $*"; return 1; }
  [[ $stderr == "$tool: "* && $stderr == *"$words"* ]] || { show "wanted '$tool: ' and '$words'"; return 1; }
  [[ $stderr != *$'\n'* ]] || show "wanted one line"
}

# refuses STATUS TOOL WORDS ARGUMENTS...: demands what mentions() does, and that nothing was written: no standard
# output, and the same files with the same bytes in this folder, where neither bats nor a test beside this one may
# write.
refuses() {
  local before
  [[ $PWD == "$BATS_TEST_TMPDIR"/?* ]] || { show "refuses needs a folder below $BATS_TEST_TMPDIR, not $PWD"; return 1; }
  before=$(here)
  mentions "$@" || return
  [[ -z $output ]] || { show "wanted nothing on standard output"; return 1; }
  [[ $before == "$(here)" ]] || show "the folder changed: $(diff <(echo "$before") <(here))"
}

# here: prints the files of this folder with their inode, size, and the times of their last changes: any byte that is written changes
# them, and a refusal need not read every file twice.
here() {
  find -L . -type f -printf '%p %i %s %T@ %C@\n' | sort
}

# same_bytes ONE OTHER: demands equal files that are not empty; the other may be a process substitution.
same_bytes() {
  [[ -s $1 ]] || { show "$1 is missing or empty"; return 1; }
  cmp "$1" "$2" || show "$1 and $2 differ"
}

# other_bytes ONE OTHER: demands different files that are not empty.
other_bytes() {
  [[ -s $1 && -s $2 ]] || { show "$1 or $2 is missing or empty"; return 1; }
  ! cmp -s "$1" "$2" || show "$1 and $2 are the same"
}

# same_text ONE OTHER, other_text ONE OTHER: compare files or process substitutions; empty text is neither equal nor
# different.
same_text() {
  local one other
  one=$(cat "$1") other=$(cat "$2")
  [[ -n $one && $one == "$other" ]] || show "texts differ, or there are none:" "$(diff <(echo "$one") <(echo "$other"))"
}
other_text() {
  local one other
  one=$(cat "$1") other=$(cat "$2")
  [[ -n $one && -n $other && $one != "$other" ]] || show "texts are the same, or one is missing:" "$one"
}

# Pieces of awk: is_number(x), true of finite numbers alone; and the columns of a table with a header by their names: c(name) is the
# number in this row, text(name) what stands there. A table without rows or without the column, and a number that is none, are faults.
is_number='function is_number(x) { return x ~ /^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?$/ }'
# shellcheck disable=SC2016  # awk's dollars
by_name=$is_number'
  function fault(what) { print "line " NR ": " what > "/dev/stderr"; faulty = 1; exit 1 }
  function text(name) { if (!(name in at)) fault("there is no column " name); return $at[name] }
  function c(name) { if (!is_number(text(name))) fault(name " is no number: " $at[name]); return $at[name] + 0 }
  BEGIN { FS = "\t" }
  NR == 1 { for (i = 1; i <= NF; ++i) { key = $i; sub(/ \[.*/, "", key); at[key] = i } next }
  END { if (faulty) exit 1; if (NR < 2) fault("the table has no rows") }'

# table PROGRAM [NAME=VALUE]... [FILE]: an awk program over the rows of a table, with c(name) and text(name). A program that finds a fault sets
# bad and exits in its END, for an exit in END replaces the status of an earlier one.
table() {
  awk "$by_name $1" "${@:2}"
}

# value FILE COLUMN ROW: prints one number of a table; rows count from 1, or "last". Without it, prints words that no
# other file gives.
value() {
  awk -v name="$2" -v row="$3" "$by_name"'
    row == "last" || NR == row + 1 { found = text(name) }
    END { if (found == "") exit 1; print found }' "$1" || { echo "(no $2 in row $3 of $1)"; return 1; }
}

# near ONE OTHER TOLERANCE (relative): demands three finite numbers.
near() {
  awk -v a="$1" -v b="$2" -v t="$3" "$is_number"'
    BEGIN { if (!is_number(a) || !is_number(b) || !is_number(t)) exit 1
      d = a - b; if (d < 0) d = -d; m = b < 0 ? -b : b; exit !(d <= t * m) }' || show "'$1' is not '$2' to '$3'"
}

# holds CONDITION NAME=NUMBER...: demands an awk condition on numbers, each of which must be one.
holds() {
  local condition=$1 argument
  local -a given=()
  shift
  for argument in "$@"; do
    awk -v x="${argument#*=}" "$is_number"'BEGIN { exit !is_number(x) }' || { show "$argument is no number"; return 1; }
    given+=(-v "$argument")
  done
  awk "${given[@]}" "BEGIN { exit !($condition) }" || show "wanted $condition of $*"
}

# needs_reference FILE: sets $reference to the path of this reference data, or skips the test.
needs_reference() {
  [[ -n ${SOILWEAVE_REFERENCE:-} ]] || skip "SOILWEAVE_REFERENCE is not set"
  reference=$SOILWEAVE_REFERENCE/$1
  [[ -e $reference ]] || skip "no $1 in SOILWEAVE_REFERENCE"
}

# analysis_inputs: makes files of every kind that analyses take, in $IN.
analysis_inputs() {
  local case
  export IN=$BATS_FILE_TMPDIR
  for case in sheared disks box bare fields; do
    "$PYTHON" "$BATS_TEST_DIRNAME/vtk_states.py" "$case" "$IN/$case.h5"
  done
}

every_tool() {
  local tool
  for tool in "$BIN"/*; do basename "$tool"; done
}

# family_of PID: prints its children and their children.
family_of() {
  local file line child
  for file in /proc/[0-9]*/stat; do
    { read -r line < "$file"; } 2> /dev/null || continue
    child=${line%% *}
    # Behind the name, which is in brackets: the state and the parent.
    [[ ${line##*) } == ?" $1 "* ]] || continue
    family_of "$child"
    echo "$child"
  done
}

# limit_time SECONDS: stops what hangs in this process, a test or setup_file, which then fails and says why. bats has a limit, but
# waits for the grandchildren that it leaves behind.
limit_time() {
  # shellcheck disable=SC2064  # the limit as it is now
  trap "echo 'stopped, for it takes more than $1 s' >&2; exit 1" USR1
  (
    trap - ERR EXIT DEBUG
    set +eET
    exec < /dev/null > /dev/null 2>&1
    # A pipe that it held would look open to its reader.
    for held in /proc/"$BASHPID"/fd/*; do
      held=${held##*/}
      ((held < 3 || held == 255)) || eval "exec $held>&-"
    done
    for ((second = 0; second < $1; ++second)); do
      sleep 1
      kill -0 $$ || exit 0
    done
    kill -USR1 $$
    self=$BASHPID
    for child in $(family_of $$); do [[ $child -eq $self ]] || kill -KILL "$child"; done
  ) &
  disown
}
# Versions of bats differ in what a test's name is while they only gather the tests of a file; what runs one is named alike.
if [[ -n ${BATS_TEST_NAME:-} && ${0##*/} == bats-exec-test ]]; then
  limit_time "${SOILWEAVE_TEST_LIMIT:-600}"
elif [[ " ${FUNCNAME[*]} " == *" setup_file "* ]]; then
  limit_time $((3 * ${SOILWEAVE_TEST_LIMIT:-600}))
fi

# study_rules ARGUMENTS...: make with the rules of the studies alone, so that it builds no tool.
study_rules() {
  printf 'SHELL := /bin/bash\n.SHELLFLAGS := -o pipefail -c\n.DELETE_ON_ERROR:\n.SECONDARY:\n.PHONY: always\nalways:\nB := unused\nSTUDIES :=\ninclude pipelines/study.mk\n' \
    > "$BATS_TEST_TMPDIR/study.mk"
  (cd "${BASH_SOURCE[0]%/*}/../.." && exec env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -r -f "$BATS_TEST_TMPDIR/study.mk" "$@")
}
