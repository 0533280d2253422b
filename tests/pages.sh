#!/bin/bash
# Compares the lists of keys on the pages of lib/ with the tools' output for --keys. With "write" it prints them anew.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "$0")/.."
BIN=${BIN:-build/bin}
faults=0
while read -r tool page; do
  new=$(mktemp)
  keys=$("$BIN/$tool" --keys)
  awk -v "keys=$keys" '
    /^<!-- keys: / { print; print "```text"; print keys; print "```"; skip = 1 }
    /^<!-- end of keys -->/ { skip = 0 }
    !skip { print }' "$page" > "$new"
  grep -q "^<!-- keys: printed by $tool --keys -->" "$page" || { echo "$page: has no place for the keys of $tool" >&2; faults=1; }
  if [[ ${1:-} == write ]]; then
    cat "$new" > "$page"
  else
    diff "$page" "$new" > /dev/null || { echo "$page: its keys are not those of '$tool --keys'; run: make pages" >&2; faults=1; }
  fi
  rm -f "$new"
done << 'END'
run-dem lib/dem/SCENARIO.md
filter-expand lib/packing/PLAN.md
fem-dem lib/fem/SCENARIO.md
END
exit $faults
