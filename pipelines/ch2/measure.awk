# The study's numbers: identified parameters, how they settled, effective sizes, distances from the laboratory.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -v folder=F -v cases='C ...' -v checked='C ...' -v round=LAST -f measure.awk > measured.tsv
function size(x) { return x < 0 ? -x : x }
function open_table(name,   line, part, n, i) {
  table = name
  if ((getline line < table) <= 0) { print "measure: cannot read " name > "/dev/stderr"; exit 1 }
  delete at
  n = split(line, part, "\t")
  for (i = 1; i <= n; ++i) { sub(/ \[.*/, "", part[i]); at[part[i]] = i }
}
function next_row(   line) {
  if ((getline line < table) <= 0) { close(table); return 0 }
  split(line, field, "\t")
  return 1
}
function get(name) { return field[at[name]] }
function put(name, value, deviation) { printf "%s\t%.6g\t%s\n", name, value, deviation == "" ? "" : sprintf("%.3g", deviation) }

BEGIN {
  OFS = "\t"
  print "name", "value", "deviation"
  parameters = split("young_modulus poisson_ratio rolling_stiffness rolling_limit friction_angle", name, " ")
  n = split(cases, list, " ")
  for (c = 1; c <= n; ++c) {
    # The first round: how the means wander and settle, as in Figs. 2.1 and 2.2.
    open_table(folder "/" list[c] "/steps1.tsv")
    rows = 0
    while (next_row()) {
      strain[++rows] = get("strain_axial")
      friction[rows] = get("friction_angle")
      first_size = get("effective_size")
    }
    put("size_first_" list[c], first_size)
    if (rows > 10) {
      # Way of the friction angle's mean, degrees per per cent of strain, before 1.5 % and in the last 1.5 %.
      way_early = way_late = span_early = span_late = 0
      for (r = 2; r <= rows; ++r) {
        d = strain[r] - strain[r - 1]
        if (strain[r] <= 1.5) { way_early += size(friction[r] - friction[r - 1]); span_early += d }
        if (strain[r] > strain[rows] - 1.5) { way_late += size(friction[r] - friction[r - 1]); span_late += d }
      }
      put("settling_" list[c], (way_late / span_late) / (way_early / span_early))
    }
    open_table(folder "/" list[c] "/steps" round ".tsv")
    while (next_row()) {
      final_size = get("effective_size")
      for (k = 1; k <= parameters; ++k) { final[k] = get(name[k]); deviation[k] = get(name[k] "_deviation") }
    }
    put("size_last_" list[c], final_size)
    put("log_modulus_" list[c], log(final[1]) / log(10))
    for (k = 1; k <= parameters; ++k) put(name[k] "_" list[c], final[k], deviation[k])
    identified[list[c], "E"] = final[1]; identified[list[c], "mu"] = final[5]; identified[list[c], "kr"] = final[3]
  }
  n = split(checked, list, " ")
  for (c = 1; c <= n; ++c) {
    delete sum; delete squares; delete count
    open_table(folder "/" list[c] "/check.tsv")
    while (next_row()) {
      s = get("set")
      ++count[s]
      for (m = 3; m <= 6; ++m) { sum[s, m] += field[m]; squares[s, m] += field[m] ^ 2 }
    }
    for (s = 0; s <= 1; ++s) {
      if (!count[s]) continue
      for (m = 3; m <= 6; ++m) {
        average[s, m] = sum[s, m] / count[s]
        v = count[s] > 1 ? (squares[s, m] - sum[s, m] ^ 2 / count[s]) / (count[s] - 1) : 0
        put(word(m) (s ? "_thesis_" : "_") list[c], average[s, m], v > 0 ? sqrt(v) : 0)
      }
    }
    if (count[0] && count[1]) for (m = 3; m <= 6; ++m) put(word(m) "_excess_" list[c], average[0, m] - average[1, m])
  }
  trend("E", 1); trend("mu", -1); trend("kr", 1)
}
function word(m) { return m == 3 ? "ratio" : m == 4 ? "volume" : m == 5 ? "ratio_whole" : "volume_whole" }
# From 0.2 to 8 MPa, Hertz-Mindlin, 1000 grains: how much a parameter grows, relative, in the direction of the thesis.
function trend(what, sign,   low, high) {
  low = "hm_1000_0.2"; high = "hm_1000_8"
  if ((low, what) in identified && (high, what) in identified)
    put("trend_" what, sign * (identified[high, what] / identified[low, what] - 1))
}
