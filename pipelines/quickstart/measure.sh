#!/bin/sh
# The quickstart's numbers, from its packings and runs alone: name, mean over the packings and their standard
# deviation, or one value of all. Under load they are of the mean curve.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: OUT=out/quickstart measure.sh SEED... > measured.tsv
set -eu

# Every program below reads tables by column name.
# shellcheck disable=SC2016 # awk's fields, not the shell's
columns='FNR == 1 || /^strain_axial \[%\]/ { for (i = 1; i <= NF; ++i) { key = $i; sub(/ \[.*/, "", key); at[key] = i } next }'

# What one packing has before loading: a line a quantity.
packing() { # SEED
  awk -F '\t' "$columns"' { printf "void_ratio\t%s\n", $at["void_ratio"] }' "$OUT/cell_$1.tsv"
  awk -F '\t' "$columns"' { printf "coordination_number\t%s\n", $at["coordination_number"] }' "$OUT/fabric_$1.tsv"
  awk '/^##PERIODIC/ { printf "cell_width\t%s\ncell_height\t%s\n", 500 * ($2 + $3), 1000 * $4; next }
    /^#/ { next } { sum += $4; ++n } END { printf "mean_radius\t%.9g\n", 1000 * sum / n }' "$OUT/grains_$1.txt"
}

printf 'name\tvalue\tdeviation\n'

for seed in "$@"; do packing "$seed"; done | awk -F '\t' '
  { d = $2 - mean[$1]; mean[$1] += d / ++n[$1]; squares[$1] += d * ($2 - mean[$1]) }
  END { for (k in n) { s = n[k] > 1 ? sqrt(squares[k] / (n[k] - 1)) : 0; printf "%s\t%.6g\t%.3g\n", k, mean[k], s } }'

for pressure in 0.2 0.5 1.0; do
  awk -F '\t' -v p="$pressure" "$columns"'
    $at["stress_ratio"] > peak { peak = $at["stress_ratio"]; scatter = $at["stress_ratio_deviation"] }
    $at["strain_volumetric"] > most { most = $at["strain_volumetric"]; spread = $at["strain_volumetric_deviation"] }
    ($1 - 8.5) ^ 2 < 1e-6 { v = $at["strain_volumetric"]; d = $at["strain_volumetric_deviation"] }
    END { printf "peak_ratio_%s\t%.6g\t%.3g\ncontraction_%s\t%.6g\t%.3g\nvolumetric_%s\t%.6g\t%.3g\n",
      p, peak, scatter, p, most, spread, p, v, d }' "$OUT/ensemble_${pressure}MPa.tsv"
done

# Root mean square of the relative difference from the laboratory's stress ratio, at its own strains.
awk -F '\t' '/^#/ || /^strain_axial/ { next }
  FILENAME == ARGV[1] { strain[++n] = $1; ratio[n] = $2; next }
  { while (k < n - 2 && strain[k + 2] <= $1) ++k
    model = ratio[k + 1] + (ratio[k + 2] - ratio[k + 1]) * ($1 - strain[k + 1]) / (strain[k + 2] - strain[k + 1])
    sum += (model / $3 - 1) ^ 2; ++m }
  END { printf "misfit_0.2\t%.6g\t\n", 100 * sqrt(sum / m) }' \
  "$OUT/ensemble_0.2MPa.tsv" data/laboratory/toyoura_drained_triaxial_0.2MPa.tsv

awk -F '\t' "$columns"' $at["strain_axial"] > 0.005 {
    d = $at["stress_obliquity_from_fabric"] / $at["stress_obliquity"] - 1; if (d < 0) d = -d; if (d > most) most = d }
  END { printf "stress_force_fabric\t%.6g\t\n", 100 * most }' "$OUT"/runs/*/shear_fabric.tsv

awk -F '\t' "$columns"'
  { if ($at["unbalanced_force"] > force) force = $at["unbalanced_force"]
    work = $at["boundary_work"]; error = $at["energy_error"]; if (error < 0) error = -error
    # Shares of next to no work mean nothing: count from 1 % axial strain.
    if ($at["strain_axial"] > 0.01 && error / work > share) share = error / work }
  END { printf "unbalanced_force\t%.6g\t\nenergy_error\t%.6g\t\n", force, share }' "$OUT"/runs/*/shear.tsv
