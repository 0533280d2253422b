#!/bin/bash
# Ensemble curves, fabric tables and the numbers of the report, from the runs. Usage: measure.sh DIRECTORY PRESSURES TWINS
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
directory=$1 pressures=$2 twins=$3
first_twin=${twins%% *}

# Rows of the triaxial stage: axial strain %, then mean and standard deviation over the twins of each column asked for.
ensemble() {
  awk -F '\t' '
    FNR == 1 { for (i = 1; i <= NF; ++i) { name = $i; sub(/ \[.*/, "", name); at[name] = i } ; station = 0; next }
    $at["stage"] == 1 {
      ++station; if (station > last) last = station
      strain[station] = 100 * $at["strain_axial"]; ++n[station]
      add("r", $at["stress_ratio"]); add("v", 100 * $at["strain_volumetric"])
      add("z", $at["mechanical_coordination_number"]); add("e", $at["void_ratio"])
    }
    function add(q, x) { sum[q, station] += x; square[q, station] += x * x }
    function average(q, k) { return sum[q, k] / n[k] }
    function deviation(q, k,  m) { m = average(q, k); d = square[q, k] / n[k] - m * m; return d > 0 && n[k] > 1 ? sqrt(d * n[k] / (n[k] - 1)) : 0 }
    END {
      print "strain_axial [%]\tstress_ratio [1]\tsd [1]\tstrain_volumetric [%]\tsd [%]\tcoordination [1]\tsd [1]\tvoid_ratio [1]\tsd [1]"
      for (k = 1; k <= last; ++k) {
        line = sprintf("%.4f", strain[k])
        for (i = 1; i <= 4; ++i) { q = substr("rvze", i, 1); line = line sprintf("\t%.6g\t%.3g", average(q, k), deviation(q, k)) }
        print line
      }
    }' "$@"
}

metric() { printf '%s\t%s\n' "$1" "$2"; }

for p in $pressures; do
  files=()
  for t in $twins; do files+=("$directory/run_${p}_$t.tsv"); done
  ensemble "${files[@]}" > "$directory/ensemble_$p.tsv"
done

homogenize "$directory/packing.h5" --tsv > "$directory/packing.tsv"
for table in rose histogram; do
  fabric "$directory/packing.h5" --table $table --tsv > "$directory/$table.tsv"
done
fabric "$directory/run_0.2_$first_twin.h5" --tsv > "$directory/fabric.tsv"
cp "$directory/run_0.2_$first_twin.tsv" "$directory/energy.tsv"

column() { awk -F '\t' -v name="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) { c = $i; sub(/ \[.*/, "", c); if (c == name) at = i } next } { print $at }' "$1"; }

# RMS of the relative difference of the mean stress ratio from a laboratory curve, %.
misfit() {
  awk -F '\t' '
    /^#/ { next }
    FNR == 1 { ++file; next }
    /^strain/ { next }
    file == 1 { x[++n] = $1; y[n] = $2; next }
    { while (k < n - 1 && x[k + 2] <= $1) ++k; if ($1 > x[n]) next
      r = k ? y[k] + (y[k + 1] - y[k]) * ($1 - x[k]) / (x[k + 1] - x[k]) : y[1]; s += (r / $3 - 1) ^ 2; ++m }
    END { printf "%.2f\n", 100 * sqrt(s / m) }' "$1" "$2"
}
peak() { awk -F '\t' 'NR > 1 && $2 > p { p = $2 } END { printf "%.3f\n", p }' "$1"; }
at_strain() { awk -F '\t' -v e="$2" -v c="$3" 'NR > 1 && ($1 - e) ^ 2 < 1e-6 { printf "%.4g\n", $c }' "$1"; }

{
  printf 'quantity\tvalue\n'
  metric void_ratio "$(column "$directory/packing.tsv" void_ratio | tail -n 1)"
  metric packing_pressure "$(column "$directory/packing.tsv" mean_stress | tail -n 1)"
  for p in $pressures; do
    metric "peak_stress_ratio_$p" "$(peak "$directory/ensemble_$p.tsv")"
    metric "volumetric_strain_8.5_$p" "$(at_strain "$directory/ensemble_$p.tsv" 8.5 4)"
  done
  for p in 0.2 0.5; do
    metric "misfit_stress_ratio_$p" "$(misfit "$directory/ensemble_$p.tsv" "data/laboratory/toyoura_drained_triaxial_${p}MPa.tsv")"
  done
  metric energy_error "$(paste <(column "$directory/energy.tsv" energy_error) <(column "$directory/energy.tsv" boundary_work) |
    tail -n 1 | awk '{ e = $1 / $2; printf "%.2e\n", e < 0 ? -e : e }')"
  metric stress_force_fabric "$(paste <(column "$directory/fabric.tsv" stress_obliquity) \
    <(column "$directory/fabric.tsv" stress_obliquity_from_fabric) | tail -n 1 | awk '{ printf "%.4f\n", $2 / $1 }')"
  metric largest_unbalanced_force "$(column "$directory/energy.tsv" unbalanced_force | tail -n +2 | sort -g | tail -n 1)"
} > "$directory/metrics.tsv.tmp"
mv "$directory/metrics.tsv.tmp" "$directory/metrics.tsv"
