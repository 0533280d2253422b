# Void ratios and unbalanced forces of the packings, and their mean stress ratio between 5 and 8 % axial strain: a mean over
# the twins of each seed, then over the seeds; the scatter is that of the seeds.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -v folder=F -v sizes='N ...' -v seeds='S ...' -v twins='T ...' -f measure.awk
function columns(line,   part, i) {
  delete at
  n_columns = split(line, part, "\t")
  for (i = 1; i <= n_columns; ++i) { sub(/ \[.*/, "", part[i]); at[part[i]] = i }
}
function row(line) { split(line, field, "\t") }
function open_table(name,   line) {
  table = name
  if ((getline line < table) <= 0) { print "measure: cannot read " name > "/dev/stderr"; exit 1 }
  columns(line)
}
function next_row(   line) {
  if ((getline line < table) <= 0) { close(table); return 0 }
  row(line)
  return 1
}
# Mean stress ratio of one test; its first row is the packing itself.
function strength(name,   sum, rows, first) {
  open_table(name)
  for (first = 1; next_row(); first = 0) {
    if (first) unbalanced = field[at["unbalanced_force"]]
    if (field[at["stage"]] == 1 && field[at["strain_axial"]] > 0.0499 && field[at["strain_axial"]] < 0.0801) {
      sum += field[at["stress_ratio"]]
      ++rows
    }
  }
  return sum / rows
}
function deviation(sum, squares, n) { return n > 1 && squares > sum * sum / n ? sqrt((squares - sum * sum / n) / (n - 1)) : 0 }
BEGIN {
  OFS = "\t"
  print "name", "value", "scatter"
  n_sizes = split(sizes, size, " "); n_seeds = split(seeds, seed, " "); n_twins = split(twins, twin, " ")
  n_pressures = split("1e3 1e5", pressure, " ")
  for (i = 1; i <= n_sizes; ++i) {
    for (p = 1; p <= n_pressures; ++p) {
      sum = squares = 0
      for (s = 1; s <= n_seeds; ++s) {
        open_table(folder "/packing_" size[i] "_" pressure[p] "_" seed[s] ".tsv")
        next_row()
        close(table)
        e = field[at["void_ratio"]]
        sum += e; squares += e * e
      }
      print "void_ratio_" size[i] "_" pressure[p], sum / n_seeds, deviation(sum, squares, n_seeds)
    }
    sum = squares = worst = 0
    for (s = 1; s <= n_seeds; ++s) {
      of_seed = 0
      for (t = 1; t <= n_twins; ++t) {
        of_seed += strength(folder "/triaxial_" size[i] "_" seed[s] "_" twin[t] ".tsv") / n_twins
        if (twin[t] == 0 && unbalanced > worst) worst = unbalanced
      }
      sum += of_seed; squares += of_seed * of_seed
    }
    mean = sum / n_seeds
    print "unbalanced_" size[i], worst, ""
    print "ratio_" size[i], mean, deviation(sum, squares, n_seeds)
    if (i == 1 || mean > largest) largest = mean
    if (i == 1 || mean < least) least = mean
  }
  if (n_sizes > 1) print "ratio_spread", largest / least - 1, ""
}
