# What is new of variants, and what was kept of those that the new lacks. Of a table the first line of both must be of the same bag.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -f merge.awk NEW [KEPT] > merged
# Tables, a line for each variant, or histories, where a variant's begins with "== NAME".
BEGIN { FS = "\t" }
FNR == 1 { ++file; table = $1 == "variant"; if (file == 1 && table) print; if (table) next }
table && FNR == 2 {
  if (file == 1) bag = $0
  else if ($0 != bag) { print "merge: " FILENAME " is of another bag: remove it, or make all variants anew" > "/dev/stderr"; exit 1 }
}
table || /^== / { name = $1; sub(/^== /, "", name); if (file == 1) there[name] }
file == 1 || !(name in there)
