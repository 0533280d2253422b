# The grains that the plane y = 0 cuts: x, z and radius of the cut (mm), deviatoric strain; the nodes of the geotextile with no strain.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: homogenize RUN --state N --grains --table grains --tsv | awk -f section.awk
BEGIN { FS = OFS = "\t" }
NR == 1 {
  for (i = 1; i <= NF; ++i) { name = $i; sub(/ \[.*/, "", name); at[name] = i }
  print "x [mm]", "z [mm]", "radius [mm]", "strain [1]"
  next
}
$at["position_y"]^2 < $at["radius"]^2 {
  print 1e3 * $at["position_x"], 1e3 * $at["position_z"], 1e3 * sqrt($at["radius"]^2 - $at["position_y"]^2),
    $at["copy"] < 0 ? "NaN" : $at["strain_deviatoric"]
}
