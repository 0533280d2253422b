# The rows of a table's last time.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -f last.awk TABLE
BEGIN { FS = "\t" }
NR == 1 {
  for (i = 1; i <= NF; ++i) if ($i ~ /^time \[/) time = i
  if (!time) { print "last: no column time" > "/dev/stderr"; failed = 1; exit 1 }
  print
  next
}
$time != now { now = $time; rows = 0 }
{ row[++rows] = $0 }
END { if (!failed) for (i = 1; i <= rows; ++i) print row[i] }
