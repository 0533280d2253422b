# Axial stress in the soil of a bag loaded fast and slowly, at every per cent of strain up to the first at which a yarn of either has broken.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -f rates.awk FAST/uc_PE.tsv SLOW/uc_PE.tsv > table
# Files of runs are named by their folder.
BEGIN { FS = "\t" }
FNR == 1 {
  name[++run] = FILENAME; sub(/\/[^\/]*$/, "", name[run]); sub(/.*\//, "", name[run])
  for (i = 1; i <= NF; ++i) { title = $i; sub(/ *\[.*/, "", title); at[title] = i }
  next
}
{ height = $at["displacement_bottom_z"] - $at["displacement_top_z"] }
$at["stage"] == 0 { start = height; next }
{
  percent = (height - start) / 0.08 * 100
  station = int(percent + 0.5)
  if (percent - station > 0.01 || station - percent > 0.01) next
  stress[run, station] = $at["soil_stress_zz"] / 1e3
  if ($at["broken_yarns"] > 0) broken[station]
}
END {
  printf "axial strain [%%]\t%s [kPa]\t%s [kPa]\tdifference [%%]\n", name[1], name[2]
  for (s = 1; (1, s) in stress && (2, s) in stress && !(s - 1 in broken); ++s)
    printf "%d\t%.2f\t%.2f\t%+.2f\n", s, stress[1, s], stress[2, s], 100 * (stress[1, s] / stress[2, s] - 1)
}
