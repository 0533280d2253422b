# Some columns of a table, by name, with seven digits.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -v names='time pull_end ...' -f keep.awk TABLE
BEGIN { FS = OFS = "\t"; count = split(names, wanted, " ") }
NR == 1 {
  for (i = 1; i <= NF; ++i) { name = $i; sub(/ \[.*/, "", name); at[name] = i }
  for (k = 1; k <= count; ++k) {
    if (!(wanted[k] in at)) { print "keep: no column " wanted[k] > "/dev/stderr"; exit 1 }
    printf "%s%s", $(at[wanted[k]]), k < count ? OFS : "\n"
  }
  next
}
{ for (k = 1; k <= count; ++k) printf "%.7g%s", $(at[wanted[k]]), k < count ? OFS : "\n" }
