#!/usr/bin/env bash
# Strengths of the thesis author's own packings of 1000, 2000 and 5000 grains, brought to grains of one size. They show how
# far two packings of one sand and void ratio lie apart; pipelines/packings is compared with that.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# make crosscheck, with SOILWEAVE_REFERENCE at the folder of recorded packings. TWINS (default 4): runs of each packing.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
BIN=$(cd "${BIN:-$here/../../build/bin}" && pwd)
PATH=$BIN:$PATH
scenario=$here/../../pipelines/quickstart/triaxial.toml
export scenario OMP_NUM_THREADS=1 LC_ALL=C.UTF-8
twins=${TWINS:-4} jobs=${JOBS:-$(nproc)}
reference=${SOILWEAVE_REFERENCE:-}
[[ -d $reference/ch2 ]] || { echo "crosscheck: no recorded packings (SOILWEAVE_REFERENCE); skipped"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# scaled GRAINS LX LY LZ: prints the packing as text, with the mean volume of its grains as in the packing of 1000.
solids=$(awk -F , 'NR > 1 { v += $4 ^ 3 } END { printf "%.17g", v / (NR - 1) }' "$reference/ch2/toyoura_rv_1000.csv")
scaled() {
  local csv=$reference/ch2/toyoura_rv_$1.csv factor
  factor=$(awk -F , -v whole="$solids" 'NR > 1 { v += $4 ^ 3 } END { printf "%.17g", (whole * (NR - 1) / v) ^ (1 / 3) }' "$csv")
  awk -F , -v k="$factor" -v x="$2" -v y="$3" -v z="$4" '
    NR == 1 { printf "##PERIODIC:: %.17g %.17g %.17g\n", k * x, k * y, k * z; next }
    { printf "%.17g %.17g %.17g %.17g\n", k * $1, k * $2, k * $3, k * $4 }' "$csv" > "$1.txt"
  pack-generate --quiet --import "$1.txt" --as-is -o "$1.h5"
}
scaled 1000 0.0462201 0.0461205 0.0921203
scaled 2000 0.050135 0.050157 0.099452
scaled 5000 0.046171 0.046258 0.092015

# one GRAINS TWIN: prints its mean stress ratio between 5 and 8 % axial strain.
one() {
  local perturb=1e-6
  [[ $2 -eq 0 ]] && perturb=0
  run-dem --quiet "$1.h5" "$scenario" --set stage.1.axial_strain=0.08 --set stage.1.rate=0.1 --perturb "$perturb" --seed "$2" -o "$1.$2.run.h5"
  homogenize --quiet --tsv --table series "$1.$2.run.h5" | awk -F '\t' -v OFS='\t' -v grains="$1" '
    NR == 1 { for (i = 1; i <= NF; ++i) { split($i, part, " "); at[part[1]] = i } next }
    $at["stage"] == 1 && $at["strain_axial"] > 0.0499 && $at["strain_axial"] < 0.0801 { sum += $at["stress_ratio"]; ++n }
    END { print grains, sum / n }'
}
SHELL=$(command -v bash)
export SHELL
export -f one
for grains in 5000 2000 1000; do
  for ((twin = 0; twin < twins; ++twin)); do echo "$grains $twin"; done
done | parallel --will-cite --jobs "$jobs" --colsep ' ' 'one {1} {2}' > ratios.tsv

echo "Stress ratio at 0.2 MPa, mean between 5 and 8 % axial strain, of the thesis author's packings ($twins twins each):"
sort -n ratios.tsv | awk -F '\t' '
  { n[$1]++; sum[$1] += $2; squares[$1] += $2 ^ 2 }
  END {
    for (g in n) {
      mean = sum[g] / n[g]
      s = n[g] > 1 && squares[g] > n[g] * mean ^ 2 ? sqrt((squares[g] - n[g] * mean ^ 2) / (n[g] - 1)) : 0
      printf "  %5d grains  %.3f, standard deviation %.3f\n", g, mean, s
      all += mean; ++sizes
    }
    printf "  all           %.3f\n", all / sizes
  }' | sort
