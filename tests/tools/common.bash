# shellcheck shell=bash
# What the tool tests share: the tools on PATH, a folder of its own for each test, and assertions that say what they saw.
# SPDX-License-Identifier: GPL-3.0-or-later
bats_require_minimum_version 1.5.0

BIN=$(cd "${BIN:-${BASH_SOURCE[0]%/*}/../../build/bin}" && pwd)
export BIN PATH="$BIN:$PATH" LC_ALL=C.UTF-8
# Debian's own interpreter has the HDF5 and VTK modules that the tests use.
export PYTHON=${PYTHON:-/usr/bin/python3}

# call COMMAND...: runs it; afterwards $status, $output (standard output), $stderr are set.
call() {
  run --separate-stderr "$@"
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
  # shellcheck disable=SC2154  # status, output and stderr are set by run
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

# mentions STATUS TOOL WORDS ARGUMENTS...: one line that starts with the tool's name and holds the words.
mentions() {
  local wanted=$1 tool=$2 words=$3
  shift 3
  call "$tool" "$@"
  [[ $status -eq $wanted ]] || { show "wanted exit status $wanted of: $tool $*"; return 1; }
  [[ $stderr == "$tool: "* && $stderr == *"$words"* ]] || { show "wanted '$tool: ' and '$words'"; return 1; }
  [[ $stderr != *$'\n'* ]] || show "wanted one line"
}

# refuses STATUS TOOL WORDS ARGUMENTS...: as mentions, and nothing was written: no standard output, and in this folder
# the same files with the same bytes.
refuses() {
  local before
  before=$(here)
  mentions "$@" || return
  [[ -z $output ]] || { show "wanted nothing on standard output"; return 1; }
  [[ $before == "$(here)" ]] || show "the folder changed: $(diff <(echo "$before") <(here))"
}

here() {
  find -L . -type f -exec sha256sum {} + | sort -k 2
}

# same_bytes ONE OTHER
same_bytes() {
  cmp "$1" "$2" || show "$1 and $2 differ"
}

# value FILE COLUMN ROW: one number of a table; rows count from 1, or "last".
value() {
  awk -F '\t' -v name="$2" -v row="$3" '
    NR == 1 { for (i = 1; i <= NF; ++i) { split($i, part, / \[/); if (part[1] == name) column = i } next }
    { last = $column } NR == row + 1 { print $column } END { if (row == "last") print last }' "$1"
}

# near ONE OTHER TOLERANCE (relative)
near() {
  awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; if (d < 0) d = -d; m = b < 0 ? -b : b; exit !(d <= t * m) }' ||
    show "$1 is not $2 to $3"
}

# needs_reference FILE: $reference is the path of this reference data; the test is skipped where there is none.
needs_reference() {
  [[ -n ${SOILWEAVE_REFERENCE:-} ]] || skip "SOILWEAVE_REFERENCE is not set"
  reference=$SOILWEAVE_REFERENCE/$1
  [[ -e $reference ]] || skip "no $1 in SOILWEAVE_REFERENCE"
}

# analysis_inputs: files of every kind that analyses take, in $IN.
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
