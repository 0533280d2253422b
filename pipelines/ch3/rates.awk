# Axial stress in the soil of bags loaded at different rates, two by two, at every per cent of strain up to the first at which a yarn of
# any has broken.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -f rates.awk FAST/uc_PE.tsv SLOW/uc_PE.tsv [FAST/uc_PE.tsv SLOW/uc_PE.tsv] > table
# Files of runs are named by their folder.
BEGIN { FS = "\t" }
FNR == 1 {
  name[++runs] = FILENAME; sub(/\/[^\/]*$/, "", name[runs]); sub(/.*\//, "", name[runs])
  for (i = 1; i <= NF; ++i) { title = $i; sub(/ *\[.*/, "", title); at[title] = i }
  next
}
{ height = $at["displacement_bottom_z"] - $at["displacement_top_z"] }
$at["stage"] == 0 { start = height; next }
{
  percent = (height - start) / 0.08 * 100
  station = int(percent + 0.5)
  if (percent - station > 0.01 || station - percent > 0.01) next
  stress[station, runs] = $at["soil_stress_zz"] / 1e3
  if ($at["broken_yarns"] > 0) broken[station]
}
function all_at(station, r) {
  for (r = 1; r <= runs; ++r) if (!((station, r) in stress)) return 0
  return 1
}
END {
  printf "axial strain [%%]"
  for (r = 1; r < runs; r += 2) printf "\t%s [kPa]\t%s [kPa]\tdifference [%%]", name[r], name[r + 1]
  print ""
  for (s = 1; all_at(s) && !(s - 1 in broken); ++s) {
    printf "%d", s
    for (r = 1; r < runs; r += 2) printf "\t%.2f\t%.2f\t%+.2f", stress[s, r], stress[s, r + 1], 100 * (stress[s, r] / stress[s, r + 1] - 1)
    print ""
  }
}
