# What each variant of the bag carries at 1, 4 and 8 % and at most, as differences from the bag itself, and where its first yarn breaks.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -v yarns=2 -f variants.awk variants.tsv bag/uc_PE.tsv VARIANT/uc_PE.tsv... > table
# Files of runs are named by their folder.
BEGIN { FS = "\t"; split("0.01 0.04 0.08", strains, " ") }
FNR == 1 { ++file; head = 0 }
/^#/ { next }
!head {
  head = 1
  run = FILENAME; sub(/\/[^\/]*$/, "", run); sub(/.*\//, "", run)
  if (file > 1) order[++runs] = run
  for (i = 1; i <= NF; ++i) { title = $i; sub(/ *\[.*/, "", title); at[title] = i }
  next
}
file == 1 { description[$1] = $5; next }
function round(x) { return int(1000 * x + 0.5) / 1000 }
{
  height = $at["displacement_bottom_z"] - $at["displacement_top_z"]
  if ($at["stage"] == 0) { start = height; loose[run] = $at["soil_void_ratio"]; next }
  strain = (height - start) / 0.08
  if ($at["broken_yarns"] > 0 && !(run in broken)) broken[run] = 100 * strain
  carried = ($at["force_top_z"] < 0 ? -1 : 1) * $at["force_top_z"] / 160
  falls[run] = carried < most[run]
  if (!falls[run]) { most[run] = carried; peak[run] = 100 * strain }
  for (k in strains)
    if (round(strain) == strains[k]) {
      load[run, k] = carried
      tension[run, k] = $at["yarn_tension_face"] / yarns
      obliquity[run, k] = $at["soil_deviatoric_stress"] / $at["soil_mean_stress"]
    }
}
function difference(values, run, k) { return run == "bag" ? 0 : 100 * (values[run, k] / values["bag", k] - 1) }
END {
  printf "variant\twhat is varied\tvoid ratio under the preload"
  for (k = 1; k <= 3; ++k) { s = 100 * strains[k]; printf "\tload at %d %% [kPa]\tload [%%]\ttension [%%]\tq/p at %d %%\tq/p [%%]", s, s }
  print "\tfirst break by [%]\tgreatest load [kPa]\tgreatest load [%]\tat [%]"
  for (n = 1; n <= runs; ++n) {
    run = order[n]
    printf "%s\t%s\t%.4f", run, description[run], loose[run]
    for (k = 1; k <= 3; ++k)
      printf "\t%.1f\t%+.1f\t%+.1f\t%.3f\t%+.1f", load[run, k], difference(load, run, k), difference(tension, run, k), obliquity[run, k],
        difference(obliquity, run, k)
    printf "\t%s", run in broken ? sprintf("%.0f", broken[run]) : "none"
    if (falls[run]) printf "\t%.1f\t%s\t%.0f\n", most[run], falls["bag"] ? sprintf("%+.1f", 100 * (most[run] / most["bag"] - 1)) : "none", peak[run]
    else print "\tnone\tnone\tnone"
  }
}
