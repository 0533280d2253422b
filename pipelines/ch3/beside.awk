# What several bags in compression have of what is published of one: a line each, a column each; scatter=1: their mean too, and its
# standard deviation, as a sample's; apart=1: the first is no part of these.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -v leave=REGEX [-v scatter=1 [-v apart=1]] -f beside.awk VARIANT/comparison.tsv... > table
# Files are named by their folder; the first one's lines are those of the table. leave: descriptions to leave out, of what runs that end
# before it cannot tell.
BEGIN { FS = OFS = "\t" }
FNR == 1 {
  name = FILENAME; sub(/\/[^\/]*$/, "", name); sub(/.*\//, "", name)
  names[++files] = name
  for (i = 1; i <= NF; ++i) at[$i] = i
  next
}
$1 ~ leave { next }
files == 1 { order[++n] = $1; line[n] = $at["description"] OFS $at["unit"] OFS $at["published"] OFS $at["tolerance"] }
{ value[files, $1] = $at["measured"] }
END {
  printf "description\tunit\tpublished\ttolerance"
  for (f = 1; f <= files; ++f) printf "\t%s", names[f]
  print scatter ? "\tmean\tdeviation" : ""
  for (k = 1; k <= n; ++k) {
    row = line[k]; sum = squares = count = 0
    for (f = 1; f <= files; ++f) row = row OFS ((f, order[k]) in value ? value[f, order[k]] : "none")
    for (f = 1 + apart; f <= files; ++f) if ((f, order[k]) in value) { sum += value[f, order[k]]; ++count }
    for (f = 1 + apart; f <= files; ++f) if ((f, order[k]) in value) squares += (value[f, order[k]] - sum / count) ^ 2
    print row (scatter ? OFS (count > 0 ? sprintf("%.4g", sum / count) : "none") OFS \
      (count > 1 ? sprintf("%.2g", sqrt(squares / (count - 1))) : "none") : "")
  }
}
