#!/bin/bash
# The parameters a case identified, and the thesis's where there are some, run through the whole test with twins; how far
# each is from the laboratory's curve.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: BIN=build/bin check.sh FOLDER LAW PACKING SCENARIO PRESSURE_MPa STEPS.tsv LABORATORY.tsv STRAIN_% THESIS.tsv > check.tsv
# Leaves the series as FOLDER/check/runs/ID/series.tsv; ID: 10 times the set (0: identified, 1: thesis) plus the twin.
set -euo pipefail
export LC_ALL=C.UTF-8
folder=$1 law=$2 packing=$3 scenario=$4 pressure=$5 steps=$6 laboratory=$7 strain=$8 thesis=$9
here=$(dirname "$0")
twins=$(seq 0 $((${CHECK_TWINS:-3} - 1)))
whole=$(tail -n 1 "$laboratory" | cut -f 1)
names="young_modulus poisson_ratio rolling_stiffness rolling_limit friction_angle"

# last FILE: the parameters in the last row of a table, by name.
last() {
  awk -F '\t' -v names="$names" 'BEGIN { n = split(names, name, " ") } /^#/ { next }
    !width { width = NF; for (i = 1; i <= NF; ++i) { key = $i; sub(/ \[.*/, "", key); at[key] = i } next } { row = $0 }
    END { split(row, value, FS); for (k = 1; k <= n; ++k) printf "%s%s", value[at[name[k]]], k < n ? "\t" : "\n" }' "$1"
}

mkdir -p "$folder/check"
rows=$folder/check/rows.tsv
{
  for twin in $twins; do printf '%s\t%s\t%s\n' "$twin" "$(last "$steps")" "$twin"; done
  if [[ -e $thesis ]]; then for twin in $twins; do printf '%s\t%s\t%s\n' $((10 + twin)) "$(last "$thesis")" "$twin"; done; fi
} > "$rows"
export BIN KEEP_RUN=1
parallel --quote --colsep '\t' --jobs "${JOBS:-100%}" "$here/run.sh" "$folder/check" "$law" "$packing" "$scenario" "$pressure" "$whole" \
  '{1}' '{2}' '{3}' '{4}' '{5}' '{6}' '{7}' :::: "$rows" >&2

printf 'set [1]\ttwin [1]\tmisfit_ratio [%%]\tmisfit_volume [%%]\tmisfit_ratio_whole [%%]\tmisfit_volume_whole [%%]\n'
while IFS=$'\t' read -r id _; do
  row=$folder/check/runs/$(printf %06d "$id")
  if [[ -e $row/series.tsv ]]; then
    printf '%s\t%s\t%s\t%s\n' $((id / 10)) $((id % 10)) "$(awk -v until="$strain" -f "$here/misfit.awk" "$row/series.tsv" "$laboratory")" \
      "$(awk -v until="$whole" -f "$here/misfit.awk" "$row/series.tsv" "$laboratory")"
  else
    echo "  $folder: the check of set $((id / 10)), twin $((id % 10)) failed: $(head -n 1 "$row/failed")" >&2
  fi
done < "$rows"
