# What is new of variants, and what was kept of those that the new lacks: of a table only if the first line of both is of the same bag.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -f merge.awk NEW [KEPT] > merged
# Tables, a line for each variant, or histories, where a variant's begins with "== NAME".
BEGIN { FS = "\t" }
FNR == 1 { ++file; table = $1 == "variant"; if (file == 1 && table) print; if (table) next }
table && FNR == 2 { if (file == 1) bag = $0; else other = $0 != bag }
table || /^== / { name = $1; sub(/^== /, "", name); if (file == 1) there[name] }
file == 2 && (name in there) { next }
other { print "merge: " FILENAME " is of another bag: remove it, or make all variants anew" > "/dev/stderr"; exit 1 }
{ print }
