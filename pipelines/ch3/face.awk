# The yarns of the upper face: both ends (mm), tension (N), whether broken.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: homogenize RUN --state N --table yarns --tsv | awk -f face.awk
BEGIN { FS = OFS = "\t" }
NR == 1 {
  for (i = 1; i <= NF; ++i) { name = $i; sub(/ \[.*/, "", name); at[name] = i }
  print "x [mm]", "y [mm]", "dx [mm]", "dy [mm]", "tension [N]", "broken [1]"
  next
}
$at["family"] == 0 && $at["position_z"] > 0 {
  half = 500 * $at["length"]
  print 1e3 * $at["position_x"] - half * $at["direction_x"], 1e3 * $at["position_y"] - half * $at["direction_y"],
    2 * half * $at["direction_x"], 2 * half * $at["direction_y"], $at["tension"], $at["broken"]
}
