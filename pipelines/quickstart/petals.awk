# Outlines of a rose's classes in the vertical plane, as polygons in x, y separated by blank lines.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -f petals.awk rose.tsv
BEGIN { FS = OFS = "\t"; vertical = 2; degree = atan2(0, -1) / 180 }
NR == 1 { for (i = 1; i <= NF; ++i) { key = $i; sub(/ \[.*/, "", key); at[key] = i } next }
$(at["plane"]) == vertical { angle[++n] = $(at["angle"]); density[n] = $(at["density"]) }
END {
  half = n > 1 ? (angle[2] - angle[1]) / 2 : 180
  print "x [1]", "y [1]"
  for (k = 1; k <= n; ++k) {
    print 0, 0
    for (j = -4; j <= 4; ++j) {
      a = (angle[k] + j / 4 * half) * degree
      print density[k] * cos(a), density[k] * sin(a)
    }
    print "0\t0\n"
  }
}
