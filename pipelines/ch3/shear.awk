# Chapter 3, simple shear of bags of PP under dead loads; loaded after measure.awk.
# SPDX-License-Identifier: GPL-3.0-or-later

# Of a bag under the load p. Rows: before the shear, of the greatest shear, of the least thickness (where it begins to dilate), and of
# 5 %, when every bag dilates and its whole state is recorded.
function shear(p, f, i, before, peak, lowest, state, half) {
  f = "ss_" p
  need(f, "soil_obliquity")
  need(f "_fabric", "a_n")
  for (before = 1; value[f, "stage", before + 1] == 0; ++before) { }
  peak = lowest = before
  for (i = before; i <= rows[f]; ++i) {
    if (size(value[f, "force_top_x", i]) > size(value[f, "force_top_x", peak])) peak = i
    if (value[f, "displacement_top_z", i] < value[f, "displacement_top_z", lowest]) lowest = i
    if (value[f, "stage", i] == 1) state = value[f, "step", i]
    soil_ratio[p] = larger(soil_ratio[p], size(value[f, "soil_stress_xz", i]) / value[f, "soil_stress_zz", i])
  }
  ratio[p] = size(value[f, "force_top_x", peak]) / size(value[f, "force_top_z", peak])
  half = int((before + rows[f]) / 2)
  lag[p] = lag_at(f, rows[f])
  lag_grows[p] = lag_at(f, rows[f]) - lag_at(f, half)
  contracted[p] = 1000 * (value[f, "displacement_top_z", before] - value[f, "displacement_top_z", lowest])
  dilated[p] = 1000 * (last(f, "displacement_top_z") - value[f, "displacement_top_z", lowest])
  unrest[p] = unsteadiness(f, lowest)
  lateral[p] = (value[f, "soil_stress_xx", peak] + value[f, "soil_stress_yy", peak]) / \
    (value[f, "soil_stress_xx", before] + value[f, "soil_stress_yy", before])
  axial[p] = value[f, "soil_stress_zz", peak] / value[f, "soil_stress_zz", before]
  for (i = before; i <= rows[f]; ++i) value[f, "shear_stress", i] = size(value[f, "soil_stress_xz", i])
  softening[p] = last(f, "shear_stress") / value[f, "shear_stress", greatest(f, "shear_stress")]
  sides[p] = 0.5 * (value[f, "yarn_tension_side_horizontal", peak] + value[f, "yarn_tension_side_vertical", peak]) / \
    value[f, "yarn_tension_face", peak]
  hoop[p] = value[f, "yarn_tension_side_horizontal", peak] / value[f, "yarn_tension_side_vertical", peak]
  path(p, f, before)
  local_paths(p, f "_groups", state, last(f, "step"))
  normal_falls[p] = last(f "_fabric", "a_n") - at_step(f "_fabric", "a_n", state)
  critical_c[p] = last(f "_fabric", "a_c")
}
# By how much the stress ratio of the soil is behind that of the plates.
function lag_at(f, i) {
  return size(value[f, "force_top_x", i]) / size(value[f, "force_top_z", i]) - \
    size(value[f, "soil_stress_xz", i]) / value[f, "soil_stress_zz", i]
}
# Of the shear from that row on: mean square of what it deviates from the mean of its neighbours, over its mean.
function unsteadiness(f, from, i, sum, mean) {
  for (i = from + 1; i < rows[f]; ++i) {
    sum += (value[f, "force_top_x", i] - (value[f, "force_top_x", i - 1] + value[f, "force_top_x", i + 1]) / 2) ^ 2
    mean += size(value[f, "force_top_x", i])
  }
  return sqrt(sum * (rows[f] - from - 1)) / mean
}
# The greatest q/p under shear is the slope of the critical state line of the bag: the path nears it, then leaves it, with greater p.
function path(p, f, before, i, top) {
  top = before + 1
  for (i = top; i <= rows[f]; ++i) if (value[f, "soil_obliquity", i] > value[f, "soil_obliquity", top]) top = i
  slope[p] = value[f, "soil_obliquity", top]
  nears[p] = slope[p] - value[f, "soil_obliquity", before]
  leaves[p] = last(f, "soil_obliquity") - slope[p]
}
function local_paths(p, f, state, end) {
  unloads_p[p] = of_groups(f, "mean_stress", end, 1) / of_groups(f, "mean_stress", state, 1)
  unloads_q[p] = of_groups(f, "deviatoric_stress", end, 1) / of_groups(f, "deviatoric_stress", state, 1)
  compresses[p] = of_groups(f, "mean_stress", end, 0) / of_groups(f, "mean_stress", state, 0)
}
# Greatest and least over the loads of the thesis' stress paths, 2.41 kN and more.
function most(of, k, x) { x = -1e9; for (k = 1; k <= m; ++k) if (load[k] >= 2410) x = larger(x, of[load[k]]); return x }
function fewest(of, k, x) { x = 1e9; for (k = 1; k <= m; ++k) if (load[k] >= 2410) x = smaller(x, of[load[k]]); return x }

END {
  m = split(loads, load, " ")
  if (!m) exit
  for (k = 1; k <= m; ++k) shear(load[k])
  least = load[1]; greatest_load = load[m]
  put("shear_ratio_first", ratio[least])
  put("shear_ratio_last", ratio[greatest_load])
  # One load alone tells nothing of how loads differ.
  if (m > 1) {
    put("shear_ratio_falls", ratio[greatest_load] - ratio[least])
    put("shear_soil_ratio_falls", soil_ratio[greatest_load] - soil_ratio[least])
    put("shear_dilation_falls", dilated[greatest_load] - dilated[least])
    put("shear_critical_c_falls", critical_c[greatest_load] - critical_c[least])
    if (greatest_load > 2410 && 2410 in slope) put("shear_slope_falls", slope[greatest_load] - slope[2410])
  }
  put("shear_lag", lag[least])
  put("shear_lag_grows", lag_grows[least])
  put("shear_contraction", contracted[least])
  put("shear_dilation", dilated[least])
  put("shear_unrest", least == 1330 && 2410 in unrest ? unrest[1330] / unrest[2410] : "none")
  put("shear_path_nears", fewest(nears))
  put("shear_path_leaves", most(leaves))
  put("shear_slope", most(slope))
  put("shear_middle_p", most(unloads_p))
  put("shear_middle_q", most(unloads_q))
  put("shear_edge_p", fewest(compresses))
  if (2410 in lateral) {
    put("shear_lateral", lateral[2410])
    put("shear_axial", axial[2410])
    put("shear_softening", softening[2410])
  }
  put("shear_sides_over_faces", sides[greatest_load])
  put("shear_hoop", hoop[greatest_load])
  put("shear_normal_falls", most(normal_falls))
}
