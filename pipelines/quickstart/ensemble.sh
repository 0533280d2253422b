#!/bin/sh
# Runs every row of a table under GNU parallel, one core a run; stopped, it goes on with the rows that are missing.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: BIN=build/bin OUT=out/quickstart ensemble.sh RUNS.tsv SCENARIO PACKING...
set -eu
runs=$1 scenario=$2
shift 2
here=$(dirname "$0")
mkdir -p "$OUT/runs"

# Results of other inputs, programs or scenarios are not resumed from.
key=$(cat "$runs" "$scenario" "$@" "$here/run.sh" "$here/shear.awk" "$BIN/run-dem" "$BIN/homogenize" "$BIN/fabric" | sha256sum)
if [ "$(cat "$OUT/runs/key" 2>/dev/null)" != "$key" ]; then
  rm -rf "$OUT/runs"
  mkdir -p "$OUT/runs"
  printf '%s\n' "$key" > "$OUT/runs/key"
fi

export BIN OUT OMP_NUM_THREADS=1
printf '  run   %s triaxial tests\n' "$(($(wc -l < "$runs") - 1))"
parallel --header : --colsep '\t' --jobs "${JOBS:-100%}" --joblog "$OUT/runs/joblog" --resume-failed \
  ${SSHLOGINFILE:+--sshloginfile "$SSHLOGINFILE" --workdir "$PWD"} --env BIN --env OUT --env OMP_NUM_THREADS \
  "$here/run.sh" '{seed}' "$scenario" '{pressure}' :::: "$runs"
