#!/bin/bash
# The rows of an ensemble as a Slurm array job, each by the same run.sh; waits until all are done.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: slurm.sh TABLE.tsv LINES FOLDER LAW PACKING SCENARIO PRESSURE_MPa STRAIN_%
#   LINES: file with the lines of the table to run, one a line. SLURM_FLAGS: further options of sbatch, as "--partition=long"
# Called by the job itself with SLURM_ARRAY_TASK_ID: runs its lines, every so many of the list.
set -euo pipefail
export LC_ALL=C.UTF-8
table=$1 lines=$2 folder=$3
here=$(dirname "$0")
most=${SLURM_ARRAY_SIZE:-1000}  # tasks; Slurm's own limit is MaxArraySize, 1001 unless configured

if [[ -n ${SLURM_ARRAY_TASK_ID:-} ]]; then
  status=0
  while read -r line; do
    IFS=$'\t' read -r -a row < <(sed -n "$((line + 1))p" "$table")
    "$here/run.sh" "${@:3}" "${row[@]:0:6}" || status=$?
  done < <(awk -v k="$SLURM_ARRAY_TASK_ID" -v most="$most" '(NR - 1) % most == k' "$lines")
  exit $status
fi

rows=$(wc -l < "$lines")
export BIN SLURM_ARRAY_SIZE=$most
read -r -a flags <<< "${SLURM_FLAGS:-}"
job=$(sbatch --parsable --job-name "$(basename "$folder")" --array "0-$(((rows < most ? rows : most) - 1))" --cpus-per-task 1 \
  --export ALL --chdir "$PWD" --output "$folder/slurm-%a.log" "${flags[@]}" --wrap "$(printf '%q ' "$here/slurm.sh" "$@")")
job=${job%%;*}
# An interrupted make takes its job along.
trap 'scancel "$job"; exit 143' INT TERM
while [[ -n $(squeue --noheader --job "$job" --format %i 2>/dev/null) ]]; do
  sleep "${SLURM_POLL:-10}"
  "$here/progress.sh" "$folder"
done
