#!/usr/bin/env bats
# Tests that every tool tells the truth about itself: help fits a screen, its examples run, pages and completion are well formed.
# SPDX-License-Identifier: GPL-3.0-or-later
load common

# Examples run in this order, in which each tool reads the output of those before it.
ORDER=(pack-generate filter-expand run-dem homogenize fabric to-vtk gws-solve pf-weight)

setup_file() {
  load common
  cd "$BATS_FILE_TMPDIR" || return
  mkdir examples
  cp "$BATS_TEST_DIRNAME"/examples/* examples/
}

setup() {
  cd "$BATS_TEST_TMPDIR" || return
}

in_order() {
  local tool
  for tool in "${ORDER[@]}"; do [[ -x $BIN/$tool ]] && echo "$tool"; done
  for tool in $(every_tool); do [[ " ${ORDER[*]} " == *" $tool "* ]] || echo "$tool"; done
}

# Prints the commands in the help text of a tool: the lines between "Example" and the next heading, indented by two.
examples_of() {
  "$1" --help | awk '/^[A-Z]/ { on = /^Example/ } on && /^  [^ ]/ { sub(/^  /, ""); print }'
}

@test "there are tools" {
  [[ -n $(every_tool) ]]
}

@test "--help fits a screen of 40 lines and 100 columns" {
  local tool
  for tool in $(every_tool); do
    exits 0 "$tool" --help
    [[ -z $stderr ]] || show "$tool --help writes to standard error"
    [[ $(wc -l <<<"$output") -le 40 ]] || show "$tool --help has $(wc -l <<<"$output") lines"
    [[ $(wc -L <<<"$output") -le 100 ]] || show "$tool --help has lines of $(wc -L <<<"$output") columns"
    [[ $(examples_of "$tool" | wc -l) -ge 1 ]] || show "$tool --help has no example"
    exits 0 "$tool" -h
  done
}

@test "--version names tool, version and licence" {
  local tool
  for tool in $(every_tool); do
    exits 0 "$tool" --version
    [[ ${lines[0]} =~ ^"$tool (soilweave) "[0-9]+\.[0-9]+\.[0-9]+$ ]] || show "$tool --version"
    [[ ${lines[1]} == *GPL-3.0-or-later* ]] || show "$tool --version: no licence"
  done
}

@test "an unknown option is told with the nearest one, status 64" {
  local tool
  for tool in $(every_tool); do
    complains 64 "$tool" "unknown option '--quite'; did you mean '--quiet'?" --quite
  done
}

@test "no arguments at all: status 64, each line starts with the tool's name" {
  local tool line
  for tool in $(every_tool); do
    call "$tool"
    [[ $status -eq 0 ]] && continue
    [[ $status -eq 64 ]] || show "$tool without arguments"
    while IFS= read -r line; do [[ $line == "$tool: "* ]] || show "$tool: $line"; done <<<"$stderr"
  done
}

@test "--man prints the same well-formed page each time" {
  local tool
  for tool in $(every_tool); do
    exits 0 "$tool" --man
    [[ ${lines[0]} == ".TH $tool 1 "* || ${lines[0]} == ".TH ${tool//-/\\-} 1 "* ]] || show "$tool --man"
    [[ $output == "$("$tool" --man)" ]] || show "$tool --man differs from call to call"
    local heading
    for heading in NAME SYNOPSIS DESCRIPTION OPTIONS EXAMPLES "EXIT STATUS"; do
      [[ $output == *".SH $heading"* ]] || show "$tool --man has no $heading"
    done
    if command -v man >/dev/null; then
      exits 0 bash -c "$tool --man | man --warnings -l -Tutf8 - >/dev/null"
      [[ -z $stderr ]] || show "$tool --man | man"
    fi
  done
}

@test "--completion is bash, completes options" {
  local tool
  for tool in $(every_tool); do
    exits 0 "$tool" --completion
    bash -n <<<"$output" || show "$tool --completion"
    exits 0 bash -c "source <($tool --completion); COMP_WORDS=($tool --vers); COMP_CWORD=1; _${tool//-/_}; \
      echo \${COMPREPLY[@]}"
    [[ $output == --version ]] || show "$tool --completion completes --vers to this"
  done
}

@test "a full disk is an error, a reader that has seen enough is not" {
  local tool
  for tool in $(every_tool); do
    exits 74 bash -c "$tool --help >/dev/full"
    [[ $stderr == "$tool: standard output: No space left on device; not everything was written" ]] || show "$tool"
    exits 0 bash -c "set -o pipefail; $tool --man | head -1"
  done
}

@test "every example in --help runs" {
  cd "$BATS_FILE_TMPDIR/examples" || return
  local tool command
  for tool in $(in_order); do
    while IFS= read -r command; do
      # An example may overwrite the output of an earlier one; readers need not see --force.
      local forced=$command
      [[ $command == *" -o "* && $command != *"|"* ]] && forced="$command --force"
      exits 0 bash -c "set -o pipefail; $forced --quiet" || show "example of $tool: $command"
    done < <(examples_of "$tool")
  done
}
