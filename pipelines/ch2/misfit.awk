# How far a run is from the laboratory up to a strain: root mean squares of the stress ratio, relative (%), and of the
# volumetric strain (% strain), at the laboratory's stations, straight between the run's.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -v until=% -f misfit.awk series.tsv laboratory.tsv   (prints both, a tab between)
BEGIN { FS = OFS = "\t" }
/^#/ { next }
/\[/ { ++table; delete at; for (i = 1; i <= NF; ++i) { key = $i; sub(/ \[.*/, "", key); at[key] = i } next }
table == 1 {
  if ($at["stage"] == 1) { strain[++n] = 100 * $at["strain_axial"]; ratio[n] = $at["stress_ratio"]; volume[n] = 100 * $at["strain_volumetric"] }
  next
}
$at["strain_axial"] <= until + 1e-9 {
  x = $at["strain_axial"]
  while (k < n - 2 && strain[k + 2] <= x) ++k
  share = (x - strain[k + 1]) / (strain[k + 2] - strain[k + 1])
  r = ratio[k + 1] + share * (ratio[k + 2] - ratio[k + 1])
  v = volume[k + 1] + share * (volume[k + 2] - volume[k + 1])
  of_ratio += (r / $at["stress_ratio"] - 1) ^ 2
  of_volume += (v - $at["strain_volumetric"]) ^ 2
  ++m
}
END { printf "%.6g\t%.6g\n", 100 * sqrt(of_ratio / m), sqrt(of_volume / m) }
