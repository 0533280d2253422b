# Cuts the shear stage out of a run's tables; strains count from its first state.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -f shear.awk series.tsv > shear.tsv; awk -f shear.awk series.tsv fabric.tsv > shear_fabric.tsv
BEGIN { FS = OFS = "\t"; both = ARGC > 2 }
FNR == 1 {
  ++table
  for (i = 1; i <= NF; ++i) { key = $i; sub(/ \[.*/, "", key); at[table, key] = i }
  if (table == 2 || !both) print
  next
}
table == 1 {
  if ($(at[1, "stage"]) == 1 && start == "") start = $(at[1, "step"])
  if (!both && $(at[1, "stage"]) == 1) print
  next
}
$(at[2, "step"]) + 0 >= start {
  if ($(at[2, "step"]) + 0 == start) $(at[2, "strain_axial"]) = 0
  print
}
