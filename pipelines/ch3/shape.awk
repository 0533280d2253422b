# Whether the bag's contacts are spread as the representative volume's: numbers of contacts of a grain, and angles of contacts from the
# vertical, the bag's once with those on the geotextile and once of soil with soil alone. The distance is that of Kolmogorov and Smirnov,
# the greatest difference of cumulative shares; beside it what two samples of these sizes exceed with a chance of 5 %.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -f shape.awk rv_histogram.tsv rv_rose.tsv bag_histogram.tsv bag_rose.tsv bag_soil_histogram.tsv bag_soil_rose.tsv
# count[file, class]; classes[file]; total[file].
function size(x) { return x < 0 ? -x : x }
function distance(one, other, k, a, b, d) {
  for (k = 0; k < classes[one] || k < classes[other]; ++k) {
    a += count[one, k] / total[one]; b += count[other, k] / total[other]
    if (size(a - b) > d) d = size(a - b)
  }
  return d
}
function row(name, n, m, d) { print name, n, m, sprintf("%.4g", d), sprintf("%.4g", 1.358 * sqrt(1 / n + 1 / m)) }
function compare(bag, of) {
  row("number of contacts" of, total[bag "_histogram"], total["rv_histogram"], distance(bag "_histogram", "rv_histogram"))
  row("angle of contacts from the vertical" of, total[bag "_rose"], total["rv_rose"], distance(bag "_rose", "rv_rose"))
}
BEGIN { FS = OFS = "\t" }
FNR == 1 {
  file = FILENAME; sub(/.*\//, "", file); sub(/\.tsv$/, "", file)
  for (k = 1; k <= NF; ++k) { name = $k; sub(/ \[.*/, "", name); at[file, name] = k }
  next
}
file ~ /rose$/ && $at[file, "plane"] != 0 { next }
{
  many = $at[file, file ~ /rose$/ ? "contacts" : "grains"]
  count[file, classes[file]++] = many
  total[file] += many
}
END {
  print "compared", "bag [1]", "representative volume [1]", "distance [1]", "distance of samples [1]"
  compare("bag", "")
  compare("bag_soil", ", soil with soil alone")
}
