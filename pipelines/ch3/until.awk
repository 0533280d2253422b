# The rows of a compression up to an axial strain.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -v strain=0.12 -f until.awk uc_PE.tsv
BEGIN { FS = "\t" }
/^#/ { print; next }
!head { head = 1; for (i = 1; i <= NF; ++i) { title = $i; sub(/ *\[.*/, "", title); at[title] = i } print; next }
{ shortened = $at["displacement_bottom_z"] - $at["displacement_top_z"] }
$at["stage"] == 0 { start = shortened }
shortened - start < 0.08 * strain + 1e-5
