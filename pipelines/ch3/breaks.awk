# The broken yarns: where they are (mm), and how near the seam of their face or side: 0 in its middle, 1 on its edge.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: homogenize RUN --state last --table yarns --tsv | awk -f breaks.awk
function size(x) { return x < 0 ? -x : x }
function larger(x, y) { return x > y ? x : y }
BEGIN { FS = OFS = "\t" }
NR == 1 {
  for (i = 1; i <= NF; ++i) { name = $i; sub(/ \[.*/, "", name); at[name] = i }
  print "x [mm]", "y [mm]", "z [mm]", "seam [1]"
  next
}
{
  on_face = $at["family"] == 0
  out = on_face ? larger(size($at["position_x"]), size($at["position_y"])) : size($at["position_z"])
  edge[on_face] = larger(out, edge[on_face])
  if (!$at["broken"]) next
  where[++n] = 1e3 * $at["position_x"] OFS 1e3 * $at["position_y"] OFS 1e3 * $at["position_z"]
  face[n] = on_face; way[n] = out
}
END { for (k = 1; k <= n; ++k) print where[k], way[k] / edge[face[k]] }
