# Mean and standard deviation over the packings of a pressure, station by station of the shear stage.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -f ensemble.awk runs/0.2MPa_*/series.tsv
BEGIN {
  FS = OFS = "\t"
  columns = split("stress_ratio strain_volumetric void_ratio coordination_number mechanical_coordination_number " \
                  "sliding_fraction unbalanced_force deviatoric_stress mean_stress", name, " ")
}
FNR == 1 {
  station = 0
  for (i = 1; i <= NF; ++i) { key = $i; sub(/ \[.*/, "", key); at[key] = i }
  next
}
$(at["stage"]) == 1 {
  for (i = 1; i <= columns; ++i) row[i] = $(at[name[i]])
  add($(at["strain_axial"]), row)
}
function add(strain, row,    i, delta) {
  ++station
  if (station > stations) stations = station
  ++count[station]
  axial[station] += strain
  for (i = 1; i <= columns; ++i) {
    delta = row[i] - mean[station, i]
    mean[station, i] += delta / count[station]
    squares[station, i] += delta * (row[i] - mean[station, i])
  }
}
END {
  printf "strain_axial [%%]"
  for (i = 1; i <= columns; ++i) {
    unit = name[i] ~ /^strain/ ? "%" : name[i] ~ /_stress$/ ? "Pa" : "1"
    printf "\t%s [%s]\t%s_deviation [%s]", name[i], unit, name[i], unit
  }
  print "\truns [1]"
  for (s = 1; s <= stations; ++s) {
    printf "%.6g", 100 * axial[s] / count[s]
    for (i = 1; i <= columns; ++i) {
      factor = name[i] ~ /^strain/ ? 100 : 1
      deviation = count[s] > 1 ? sqrt(squares[s, i] / (count[s] - 1)) : 0
      printf "\t%.8g\t%.6g", factor * mean[s, i], factor * deviation
    }
    printf "\t%d\n", count[s]
  }
}
