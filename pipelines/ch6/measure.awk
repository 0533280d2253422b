# What thesis §6.4 and §6.5 state, as numbers from the runs.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -v folder=F -v main=SQUARES_SPEED -v meshes='S_V ...' -v speeds='S_V ...' [-v partial=1] -f measure.awk
# partial: of runs that are not in the folder nothing is said.
function open_table(name,   line, part, i, n) {
  table = name
  if ((getline line < table) <= 0) { print "measure: cannot read " name > "/dev/stderr"; exit 1 }
  delete at
  n = split(line, part, "\t")
  for (i = 1; i <= n; ++i) { sub(/ \[.*/, "", part[i]); at[part[i]] = i }
}
function there(name,   line, read) {
  if (!partial) return 1
  read = getline line < (folder "/" name ".tsv")
  close(folder "/" name ".tsv")
  return read > 0
}
# Those of some runs of an example that are there.
function present(example, list,   runs, n, i, found) {
  n = split(list, runs, " ")
  for (i = 1; i <= n; ++i) if (there(example "_" runs[i])) found = found " " runs[i]
  return found
}
function next_row(   line) {
  if ((getline line < table) <= 0) { close(table); return 0 }
  split(line, field, "\t")
  return 1
}
function get(name) { return field[at[name]] + 0 }
function absolute(x) { return x < 0 ? -x : x }
# A curve y(pull) of a run: rows[key], x[key, i], y[key, i]; also the last time and value.
function curve(key, run, what,   n) {
  open_table(folder "/" run ".tsv")
  for (n = 0; next_row(); ) {
    x[key, ++n] = get("pull_end")
    t[key, n] = get("time")
    y[key, n] = what == "vertical" ? get("force_y_bottom") / get("length_bottom") : -get("interface_shear") / get("interface_normal")
    if (what == "vertical") y[key, n] = absolute(y[key, n])
  }
  rows[key] = n
}
function value(key, pull,   i) {
  for (i = 2; i <= rows[key]; ++i)
    if (x[key, i] >= pull) return y[key, i - 1] + (y[key, i] - y[key, i - 1]) * (pull - x[key, i - 1]) / (x[key, i] - x[key, i - 1])
  return y[key, rows[key]]
}
# Mean over the pull between two values.
function average(key, from, to,   i, sum, n) {
  for (i = 0; i <= 20; ++i) { sum += value(key, from + (to - from) * i / 20); ++n }
  return sum / n
}
# Spread of the curves of some runs, of means over stretches of 3 cm, relative to the greatest mean.
function spread(example, list, what, from,   runs, n, i, a, low, high, v, worst, top) {
  n = split(list, runs, " ")
  for (i = 1; i <= n; ++i) curve("spread" i, example "_" runs[i], what)
  for (a = from; a < 0.2401; a += 0.03) {
    low = 1e300; high = -1e300
    for (i = 1; i <= n; ++i) { v = average("spread" i, a, a + 0.03); if (v < low) low = v; if (v > high) high = v }
    if (high > top) top = high
    if (high - low > worst) worst = high - low
  }
  return worst / top
}
# Pull at which the mean over 1 cm first passes a tenth of the mean over the last 3 cm, cm.
function onset(key,   a, end) {
  end = average(key, 0.22, 0.25)
  for (a = 0; a < 0.24; a += 0.0025) if (average(key, a, a + 0.01) > 0.1 * end) return 100 * (a + 0.005)
  return 25
}
# The history h[what, k], k = 1 .. steps, of the point that the thesis follows.
function follow(example,   n) {
  open_table(folder "/" example "_" main "_local.tsv")
  for (n = 0; next_row(); ) {
    ++n
    h["q", n] = get("deviatoric_stress"); h["p", n] = get("mean_stress"); h["v", n] = get("strain_volumetric")
    h["s", n] = get("strain_shear"); h["F", n] = get("anisotropy")
  }
  return n
}
# Mean and standard deviation of a quantity of the point from row `from` to `to`.
function stretch(what, from, to,   k, sum, square, n) {
  for (k = int(from); k <= to; ++k) { sum += h[what, k]; square += h[what, k] ^ 2; ++n }
  mean = sum / n
  deviation = square / n > mean ^ 2 ? sqrt(square / n - mean ^ 2) : 0
}
# q/p of means: the packings of a few rods fluctuate.
function ratio(from, to,   k, q, p) {
  for (k = int(from); k <= to; ++k) { q += h["q", k]; p += h["p", k] }
  return p > 0 ? q / p : 0
}
function say(name, number) { print name, sprintf("%.5g", number), "" }

BEGIN {
  OFS = "\t"; FS = "\t"
  print "name", "value", "scatter"
  shape_forming()
  pull_out()
}

function shape_forming(   n, k, runs, least, top, top_n, rest, rest_n, left, right, start, last) {
  n = split(present("shape", meshes), runs, " ")
  if (n > 1) {
    say("shape_mesh_spread", spread("shape", present("shape", meshes), "vertical", 0.06))
    curve("coarse", "shape_" runs[1], "vertical"); curve("fine", "shape_" runs[n], "vertical")
    say("shape_onset_delay", onset("fine") - onset("coarse"))
  }
  if (split(present("shape", speeds), runs, " ") > 1) say("shape_speed_spread", spread("shape", present("shape", speeds), "vertical", 0.06))
  if (!there("shape_" main)) return
  curve("main", "shape_" main, "vertical")
  say("shape_onset", onset("main"))
  n = follow("shape")
  # Before and after the onset, by the pull.
  start = int(n * onset("main") / 25)
  if (start < 3) start = 3
  say("A_obliquity_first", ratio(2, start))
  say("A_obliquity_falls", ratio(2, start) - ratio(0.9 * n, n))
  least = 0
  for (k = 1; k <= n; ++k) if (h["v", k] < least) { least = h["v", k]; last = k }
  say("A_dilation", -100 * least)
  # Where it is most dilated, by the pull, which grows evenly from 0 to 25 cm; and the state up to there.
  say("A_contracts_from", 25 * (last - 1) / (n - 1))
  say("A_obliquity_dilating", ratio(2, last))
  say("A_contraction", 100 * (h["v", n] - least))
  stretch("F", 0.9 * n, n)
  say("A_anisotropy_end", mean)
  open_table(folder "/shape_" main "_last_points.tsv")
  squares = main; sub(/_.*/, "", squares)
  while (next_row()) {
    # Elements are counted from the bottom, row by row: the last row lies under the top.
    if (get("element") >= 2 * squares * (squares - 1)) { top += get("strain_shear"); ++top_n } else { rest += get("strain_shear"); ++rest_n }
    if (get("x") < 0.6) left += get("mean_stress"); else right += get("mean_stress")
  }
  say("shape_top_shear", (top / top_n) / (rest / rest_n))
  say("shape_asymmetry", absolute(left - right) / absolute(left + right) * 100)
  balance("shape")
}

# Slope of the friction ratio over the first 2 mm of pull, 1/s.
function rate(key) { return (value(key, 0.002) - y[key, 1]) / (0.002 / (x[key, rows[key]] / t[key, rows[key]])) }

function pull_out(   n, k, runs, v, part, left, left_n, right, right_n, centre, u, x0, column_sum, q1, f1, squares, along, along_n) {
  n = split(present("pullout", speeds), runs, " ")
  if (n > 1) {
    curve("slow", "pullout_" runs[1], "friction"); curve("fast", "pullout_" runs[n], "friction")
    split(runs[1], part, "_"); v = part[2]; split(runs[n], part, "_"); v = part[2] / v
    say("pullout_rate", rate("fast") / rate("slow") / v)
  }
  if (split(present("pullout", meshes), runs, " ") > 1)
    say("pullout_mesh_spread", spread("pullout", present("pullout", meshes), "friction", 0.03))
  if (there("swinging_" main)) {
    curve("swinging", "swinging_" main, "friction")
    say("swinging_friction", average("swinging", 0.1, 0.2))
  }
  if (!there("pullout_" main)) return
  curve("main", "pullout_" main, "friction")
  say("pullout_friction", average("main", 0.1, 0.2))
  open_table(folder "/pullout_" main "_last_nodes.tsv")
  while (next_row()) {
    x0 = get("x") - get("displacement_x")
    u = get("displacement_y")
    if (x0 < 0.31) { left += u; ++left_n }
    if (x0 > 0.89) { right += u; ++right_n }
    column_sum[sprintf("%.4f", x0)] += u
  }
  say("pullout_settlement", -1000 * left / left_n)
  say("pullout_heave", 1000 * right / right_n)
  centre = 1.2
  for (k in column_sum) if (column_sum[k] > 0 && k + 0 < centre) centre = k + 0
  say("pullout_centre", centre)
  n = follow("pullout")
  # At rest at its plateau: change of the mean from the middle third to the last, and scatter.
  stretch("q", n / 3, 2 * n / 3); q1 = mean
  stretch("q", 2 * n / 3, n)
  say("B_q_rises", mean / (h["q", 1] > 1 ? h["q", 1] : 1))
  say("B_q_change", 100 * absolute(mean - q1) / mean)
  stretch("F", n / 3, 2 * n / 3); f1 = mean
  stretch("F", 2 * n / 3, n)
  say("B_F_rises", mean - h["F", 1])
  say("B_F_change", 100 * absolute(mean - f1) / mean)
  stretch("v", 0.95 * n, n)
  say("B_volumetric", 100 * mean)
  # B is one of two kinds of triangles along the inclusion, with a side or a corner on it: means between a quarter and three of its length.
  open_table(folder "/pullout_" main "_last_points.tsv")
  squares = main; sub(/_.*/, "", squares)
  while (next_row()) {
    if (get("element") >= 2 * squares || get("x") < 0.3 || get("x") > 0.9) continue
    k = get("y") < 0.6 / squares ? "side" : "corner"
    along[k] += 100 * get("strain_volumetric"); ++along_n[k]
  }
  for (k in along) say("along_volumetric_" k, along[k] / along_n[k])
  balance("pullout")
}

function balance(example,   worst, e) {
  open_table(folder "/" example "_" main ".tsv")
  while (next_row()) e = get("external_work") != 0 ? absolute(get("energy_error") / get("external_work")) : 0
  say(example "_energy", 100 * e)
}
