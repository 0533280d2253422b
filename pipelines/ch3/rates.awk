# Axial stress in the soil under plates of 10 and of 1 %/s, held at every per cent and at every quarter per cent, up to the first station
# at which a yarn has broken in any of the four.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -f rates.awk fast/uc_PE.tsv slow/uc_PE.tsv held_often/uc_PE.tsv slow_held_often/uc_PE.tsv > table
BEGIN {
  FS = "\t"
  printf "axial strain [%%]"
  split("1 %|0.25 %", increments, "|")
  for (i = 1; i <= 2; ++i)
    printf "\tat 10 %%/s, held at every %s [kPa]\tat 1 %%/s, held at every %s [kPa]\tdifference [%%]", increments[i], increments[i]
  print ""
}
FNR == 1 {
  ++run
  for (i = 1; i <= NF; ++i) { title = $i; sub(/ *\[.*/, "", title); at[title] = i }
  next
}
{ height = $at["displacement_bottom_z"] - $at["displacement_top_z"] }
$at["stage"] == 0 { start = height; next }
{
  percent = 100 * (height - start) / 0.08
  station = int(percent + 0.5)
  if (percent - station > 0.01 || station - percent > 0.01) next
  stress[station, run] = $at["soil_stress_zz"] / 1e3
  if ($at["broken_yarns"] > 0) broken[station]
}
END {
  for (s = 1; (s, 1) in stress && (s, 2) in stress && (s, 3) in stress && (s, 4) in stress; ++s) {
    printf "%d", s
    for (r = 1; r <= 3; r += 2) printf "\t%.2f\t%.2f\t%+.1f", stress[s, r], stress[s, r + 1], 100 * (stress[s, r] / stress[s, r + 1] - 1)
    print ""
    if (s in broken) exit
  }
}
