#!/bin/bash
# Ten soils, each packed at four void ratios from grading, void ratio and pressure alone. The answer has to be a packing that
# holds the void ratio at rest within 0.002, or one line that says which void ratios are in reach.
# SPDX-License-Identifier: GPL-3.0-or-later
#   BIN=build/bin [OUT=folder] [JOBS=2] [SOILS='0.15_1.2 20_2.5'] [VOID_RATIOS='0.60 0.75'] tests/soils.sh
# Prints a table: soil, requested and reached void ratio, status, steps, seconds, message. Fails unless each attempt ends
# with status 0 and the requested void ratio, or with status 1 and a range or a file.
set -uo pipefail
export LC_ALL=C.UTF-8
BIN=$(realpath "${BIN:-build/bin}")
export BIN OUT=${OUT:-build/soils} OMP_NUM_THREADS=1
# Median diameter in mm by mass, and coefficient of uniformity.
read -ra soils <<< "${SOILS:-0.15_1.2 0.15_2 0.2_1.5 0.5_1.5 0.5_3 1_2 2_1.2 2_4 10_1.5 20_2.5}"
read -ra void_ratios <<< "${VOID_RATIOS:-0.60 0.65 0.70 0.75}"
mkdir -p "$OUT"

# grading D50 CU: prints a lognormal curve by mass, D60 over D10 = CU, within 1.6 standard deviations.
grading() {
  awk -v d50="$1" -v cu="$2" '
    function normal(z,   k, t, sum) {  # the integral of the density, by Simpson
      for (k = 0; k <= 400; ++k) { t = z * k / 400; sum += (k % 400 ? (k % 2 ? 4 : 2) : 1) * exp(-t * t / 2) }
      return 0.5 + sum * z / 1200 / sqrt(2 * 3.14159265358979)
    }
    BEGIN {
      print "diameter [mm]\tfiner_by_mass [1]"
      sigma = log(cu) / 1.5349; low = normal(-1.6); high = normal(1.6)
      for (k = 0; k <= 8; ++k) {
        z = -1.6 + 0.4 * k
        printf "%.6g\t%.6g\n", d50 * exp(sigma * z), k < 8 ? (normal(z) - low) / (high - low) : 1
      }
    }'
}

attempt() {
  local soil=$1 asked=$2 name=$OUT/$1_$2 begin=$EPOCHREALTIME status got='' said steps
  "$BIN/pack-generate" --force --grading "$OUT/$soil.tsv" --void-ratio "$asked" --pressure 1e5 -o "$name.h5" 2> "$name.log"
  status=$?
  said=$(grep -v ' steps of \| % done\| doubt: ' "$name.log" | tail -1)
  steps=$(sed -n 's/^pack-generate: \([0-9]*\) steps of.*/\1/p' "$name.log")
  [[ -e $name.h5 ]] && got=$("$BIN/homogenize" --tsv "$name.h5" | awk -F '\t' '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i ~ /^void_ratio /) column = i } NR == 2 { printf "%.4f", $column }')
  local verdict=wrong
  case $status in
    0) awk -v a="$asked" -v g="$got" 'BEGIN { exit !(g != "" && g - a < 0.00205 && a - g < 0.00205) }' && verdict=held ;;
    1) [[ $said == *'ask for '* ]] && verdict=told ;;
  esac
  printf '%s\t%s\t%s\t%s\t%s\t%s\t%.1f\t%s\n' "$soil" "$asked" "$got" "$status" "$verdict" "$steps" \
    "$(awk -v a="$begin" -v b="$EPOCHREALTIME" 'BEGIN { print b - a }')" "$([[ $status == 0 ]] || echo "$said")"
}
export -f attempt

for soil in "${soils[@]}"; do grading "${soil%_*}" "${soil#*_}" > "$OUT/$soil.tsv"; done
printf 'soil\tasked\tgot\tstatus\tverdict\tsteps\tseconds\tsaid\n' | tee "$OUT/table.tsv"
# shellcheck disable=SC2016  # the inner shell expands them
parallel --will-cite --quote --jobs "${JOBS:-2}" bash -c 'attempt "$1" "$2"' attempt \
  ::: "${soils[@]}" ::: "${void_ratios[@]}" | tee -a "$OUT/table.tsv"
awk -F '\t' 'NR > 1 { ++n[$5] } END {
  printf "%d held, %d told what is in reach, %d wrong\n", n["held"], n["told"], n["wrong"]; exit n["wrong"] > 0 }' "$OUT/table.tsv"
