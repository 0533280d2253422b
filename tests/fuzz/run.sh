#!/usr/bin/env bash
# Fuzzes every reader for some time each. Seeds are the repository's files of that kind, and earlier findings in
# tests/fuzz/corpus/READER. A finding ends the script and leaves its bytes in tests/fuzz/corpus/READER-*.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: BIN=build/bin [FUZZ_TIME=600] tests/fuzz/run.sh TARGET...   (each build/fuzz/tests/NAME)
set -euo pipefail
export LC_ALL=C.UTF-8
here=$(cd "$(dirname "$0")" && pwd)
top=$here/../..
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export TMPDIR=$work ASAN_OPTIONS=detect_leaks=1 BIN
export LSAN_OPTIONS=suppressions=$here/leaks_of_libraries.txt:print_suppressions=0

seeds() { # READER: into the folder of that name
  local into=$work/$1
  mkdir -p "$into"
  [[ ! -d $here/corpus/$1 ]] || cp "$here/corpus/$1"/* "$into"
  case $1 in
    scenario) find "$top/pipelines" "$top/data" "$top/tests" -name '*.toml' -exec cp --backup=numbered -t "$into" {} + ;;
    table) find "$top/data" "$top/tests" -name '*.tsv' -size -40k -exec cp --backup=numbered -t "$into" {} + ;;
    spheres) cp "$top/tests/tools/examples/spheres.txt" "$into" ;;
    file)
      (cd "$into"
        "$BIN/pack-generate" --quiet --grains 40 --dimension 2 --pressure 1e5 --tolerance 1e-2 -o packing.h5
        "$BIN/run-dem" --quiet packing.h5 "$top/tests/tools/examples/triaxial.toml" --set stage.1.axial_strain=0.001 \
          --set stage.1.increment=0.001 -o run.h5
        "$BIN/homogenize" --quiet run.h5 -o fields.h5
        "$BIN/pf-weight" draw "$top/tests/tools/examples/prior.toml" --quiet --samples 4 -o ensemble.h5)
      ;;
  esac
}

for target in "$@"; do
  reader=$(basename "$target")
  seeds "$reader"
  echo "fuzz: $reader, ${FUZZ_TIME:-600} s from $(find "$work/$reader" -type f | wc -l) seeds"
  "$target" -max_total_time="${FUZZ_TIME:-600}" -timeout=10 -rss_limit_mb=2048 -max_len=65536 -print_final_stats=1 \
    -artifact_prefix="$here/corpus/$reader-" "$work/$reader" > "$work/log" 2>&1 || {
    tail -n 40 "$work/log" >&2
    exit 1
  }
  sed -n 's/^stat::number_of_executed_units: */  executions: /p; s/^stat::new_units_added: */  inputs that reached something new: /p' \
    "$work/log"
done
