# The history of point A (shape: under the middle of the top) or B (pullout: above the inclusion), and the last state.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -v example=shape|pullout -f local.awk points.tsv
BEGIN { FS = OFS = "\t"; best = 1e300; py = example == "shape" ? 1.2 : 0 }
FNR == 1 { for (i = 1; i <= NF; ++i) { name = $i; sub(/ \[.*/, "", name); at[name] = i } next }
{
  if ($at["time"] == 0) {
    d = ($at["x"] - 0.6) ^ 2 + ($at["y"] - py) ^ 2
    if (d < best - 1e-12) { best = d; mine = $at["point"] }
    start[$at["point"]] = $0
  }
  if ($at["time"] > 0 && !printed) { printed = 1; print header(); split(start[mine], f, "\t"); print_row_of(f) }
  if ($at["time"] > 0 && $at["point"] == mine) { split($0, f, "\t"); print_row_of(f) }
}
function header() { return "time [s]\tstrain_shear [1]\tstrain_volumetric [1]\tmean_stress [Pa]\tdeviatoric_stress [Pa]\tanisotropy [1]" }
function print_row_of(f) {
  print f[at["time"]], f[at["strain_shear"]], f[at["strain_volumetric"]], f[at["mean_stress"]], f[at["deviatoric_stress"]], f[at["anisotropy"]]
}
