# Increments of p* and of plastic axial strain added up, series by series, with the strain that its Young's modulus gives.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -f accumulate.awk stiffness.tsv increments.tsv
BEGIN { FS = OFS = "\t"; print "series [1]", "generalized_stress [kPa]", "plastic_axial [%]", "fitted [%]" }
FNR == 1 { for (i = 1; i <= NF; ++i) { name = $i; sub(/ \[.*/, "", name); at[name] = i } next }
FILENAME == ARGV[1] { modulus[$at["series"]] = $at["young_modulus"]; next }
{
  s = $at["series"]
  if (!(s in stress)) print s, 0, 0, 0
  stress[s] += $at["generalized_stress"]
  strain[s] += $at["plastic_axial"]
  print s, stress[s] / 1e3, 100 * strain[s], 100 * stress[s] / modulus[s]
}
