# The last lines of a check: what was skipped, a line for each reason. Reads lines of who, what and why, with tabs between them.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { FS = "\t" }
{
  if (!($3 in what)) reasons[++n] = $3
  what[$3] = what[$3] (what[$3] == "" ? "" : "; ") $1 ": " $2
  ++number[$3]
}
END {
  if (!n) { print "make check: everything passed, nothing was skipped"; exit }
  print "make check: everything that ran passed; skipped (" NR "):"
  for (i = 1; i <= n; ++i) printf "  %s (%d): %s\n", reasons[i], number[reasons[i]], what[reasons[i]]
}
