# The numbers of chapter 5's analytical part: responses beside discrete-element series, identified constants, trends.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -f measure.awk uniaxial_*.tsv triaxial_*.tsv LINES.tsv soilbag_uniaxial_*.tsv > measured.tsv
# value[file, column, row] in SI; rows[file]. Files are named by their last part without the ending.
function name_of(path) { sub(/.*\//, "", path); sub(/\.tsv$/, "", path); return path }
function factor(unit) { return unit == "%" ? 0.01 : unit ~ /^k/ ? 1000 : 1 }

# The column y of a file where its column x is `at`, straight between rows; beyond the last row from the last two.
function between(file, x, y, at, i) {
  i = 1
  while (i < rows[file] - 1 && value[file, x, i + 1] < at) ++i
  return value[file, y, i] + (value[file, y, i + 1] - value[file, y, i]) * (at - value[file, x, i]) / \
    (value[file, x, i + 1] - value[file, x, i])
}
function last(file, column) { return value[file, column, rows[file]] }
function put(name, number) { printf "%s\t%.6g\t\n", name, number }
function size(x) { return x < 0 ? -x : x }

# Root mean square of model less discrete elements at equal axial strain up to their greatest surcharge, % of their greatest.
function misfit(g, column, y, i, d, sum, most) {
  sum = most = 0
  for (i = 1; i <= peak[g]; ++i) {
    d = between("uniaxial_" g, "strain_axial", y, value["soilbag_uniaxial_" g, "strain_axial", i]) - value["soilbag_uniaxial_" g, column, i]
    sum += d * d
    if (value["soilbag_uniaxial_" g, column, i] > most) most = value["soilbag_uniaxial_" g, column, i]
  }
  return 100 * sqrt(sum / peak[g]) / most
}

# Mean strain of the hoops of the discrete elements: horizontal ones, and vertical ones over faces and sides.
function hoop(g, i, file) {
  file = "soilbag_uniaxial_" g
  return (value[file, "strain_yarn_horizontal", i] + (5 * value[file, "strain_yarn_face", i] + value[file, "strain_yarn_vertical", i]) / 6) / 2
}

# Largest distance of surcharge over hoop strain from the straight line through its ends, % of the greatest surcharge.
function curvature(file, i, d, most) {
  most = 0
  for (i = 1; i <= rows[file]; ++i) {
    d = value[file, "surcharge", i] - last(file, "surcharge") * value[file, "hoop_strain", i] / last(file, "hoop_strain")
    if (size(d) > most) most = size(d)
  }
  return 100 * most / last(file, "surcharge")
}

# Slope of surcharge over settlement at a share of the final settlement.
function stiffness(file, share, e) {
  e = share * last(file, "strain_axial")
  return (between(file, "strain_axial", "surcharge", e * 1.02) - between(file, "strain_axial", "surcharge", e * 0.98)) / (0.04 * e)
}

# Increase of volume over deviatoric strain, total strains, over the last row.
function total_dilation(file, n) {
  n = rows[file]
  return (value[file, "strain_volumetric", n - 1] - value[file, "strain_volumetric", n]) / \
    (value[file, "strain_deviatoric", n] - value[file, "strain_deviatoric", n - 1])
}

BEGIN { FS = "\t"; print "name\tvalue\tdeviation" }
/^#/ { next }
FILENAME != current {
  current = FILENAME
  file = name_of(FILENAME)
  for (i = 1; i <= NF; ++i) {
    unit = $i; sub(/.*\[/, "", unit); sub(/\].*/, "", unit)
    column[i] = $i; sub(/ \[.*/, "", column[i])
    scale[i] = index($i, "[") ? factor(unit) : 1
  }
  next
}
{ ++rows[file]; for (i = 1; i <= NF; ++i) value[file, column[i], rows[file]] = $i * scale[i] }

function uniaxial(g, file, dem, i, above, points, model, limit, beyond) {
  file = "uniaxial_" g
  dem = "soilbag_uniaxial_" g
  for (i = 1; i <= rows[dem]; ++i)
    if (!(g in peak) || value[dem, "surcharge", i] > value[dem, "surcharge", peak[g]]) peak[g] = i
  put("ultimate_" g, last(file, "surcharge") / 1e3)
  put("settlement_" g, 100 * last(file, "strain_axial"))
  put("excess_" g, 100 * (last(file, "surcharge") / value[dem, "surcharge", peak[g]] - 1))
  put("settlement_difference_" g, 100 * (last(file, "strain_axial") - value[dem, "strain_axial", peak[g]]))
  put("misfit_lateral_" g, misfit(g, "radial_stress", "radial_stress"))
  put("misfit_axial_" g, misfit(g, "axial_stress", "axial_stress"))
  put("misfit_surcharge_" g, misfit(g, "surcharge", "surcharge"))
  put("volumetric_" g, 100 * last(file, "strain_volumetric"))
  put("volumetric_difference_" g, 100 * (last(file, "strain_volumetric") - value[dem, "strain_volumetric", peak[g]]))
  # Share of the discrete elements' points of surcharge over hoop strain that lie above the model.
  above = points = beyond = 0
  for (i = 2; i <= peak[g]; ++i) {
    limit = hoop(g, i)
    if (limit <= 0 || limit > last(file, "hoop_strain")) continue
    ++points
    model = between(file, "hoop_strain", "surcharge", limit)
    if (value[dem, "surcharge", i] > model) ++above
    beyond += value[dem, "surcharge", i] / model - 1
  }
  put("hoops_excess_" g, 100 * beyond / points)
  put("hoops_above_" g, 100 * above / points)
}

END {
  n = split("PE PP 3PP", analysed, " ")
  for (k = 1; k <= n; ++k) uniaxial(analysed[k])
  most = split("PE 0.5PP PP 2PP 3PP 4PP 5PP", all, " ")
  falls = efficiency_rises = slope_rises = flattens = 0
  for (k = 1; k <= most; ++k) {
    file = "uniaxial_" all[k]
    slope[k] = last(file, "reinforcing_efficiency") / (100 * last(file, "hoop_strain"))
    put("hoop_slope_" all[k], slope[k])
    put("curvature_" all[k], curvature(file))
    early[k] = stiffness(file, 0.3) / stiffness(file, 0.05)
    late[k] = stiffness(file, 0.97) / stiffness(file, 0.6)
    if (k == 1 || early[k] < least_hardening) least_hardening = early[k]
    if (size(late[k] - 1) > bent) bent = size(late[k] - 1)
    if (k > 2 && slope[k] > slope[k - 1]) ++slope_rises
    if (k > 3 && size(slope[k] - slope[k - 1]) > size(slope[k - 1] - slope[k - 2])) ++flattens
    if (k > 2 && last(file, "strain_axial") <= last("uniaxial_" all[k - 1], "strain_axial")) ++falls
    if (k > 1 && last(file, "reinforcing_efficiency") >= last("uniaxial_" all[k - 1], "reinforcing_efficiency")) ++efficiency_rises
    for (i = 1; i <= rows[file]; ++i) {
      confined = value[file, "axial_stress", i] - value[file, "surcharge", i]
      if (!seen++ || confined < least_confined) least_confined = confined
    }
    ratio = between(file, "strain_axial", "surcharge", 0.08) / between(file, "strain_axial", "axial_stress", 0.08)
    if (k == 1 || ratio < low) low = ratio
    if (k == 1 || ratio > high) high = ratio
    stress = between(file, "strain_axial", "axial_stress", 0.08)
    if (k == 1 || stress < weak) weak = stress
    if (k == 1 || stress > strong) strong = stress
  }
  put("settlement_falls", falls)
  put("efficiency_rises", efficiency_rises)
  put("hoop_slope_rises", slope_rises)
  put("hoop_slope_diverges", flattens)
  put("hardening", least_hardening)
  put("late_bending", 100 * bent)
  put("least_confinement", least_confined / 1e3)
  put("spread_of_ratio", 100 * (high / low - 1))
  put("spread_of_stress", strong / weak)

  split("10 50 100", pressures, " ")
  split("PE PP 5PP", sheared, " ")
  unordered = unordered_settlement = 0
  for (k = 1; k <= 3; ++k) {
    for (j = 1; j <= 3; ++j) {
      file = "triaxial_" sheared[k] "_" pressures[j] "kPa"
      before = j > 1 ? "triaxial_" sheared[k] "_" pressures[j - 1] "kPa" : "uniaxial_" sheared[k]
      if (last(file, "surcharge") <= last(before, "surcharge")) ++unordered
      if (last(file, "strain_axial") <= last(before, "strain_axial")) ++unordered_settlement
      shift = between(file, "strain_deviatoric", "strain_volumetric", 0.08) - \
        between("uniaxial_" sheared[k], "strain_deviatoric", "strain_volumetric", 0.08)
      if (size(shift) > size(contraction_by_pressure)) contraction_by_pressure = shift
      put("start_" sheared[k] "_" pressures[j], value[file, "surcharge", 1] / 1e3)
    }
    put("spread_" sheared[k], 100 * (last("triaxial_" sheared[k] "_100kPa", "surcharge") / last("triaxial_" sheared[k] "_10kPa", "surcharge") - 1))
    put("dilation_" sheared[k], total_dilation("triaxial_" sheared[k] "_10kPa"))
    put("volumetric_at_8_" sheared[k], 100 * between("uniaxial_" sheared[k], "strain_deviatoric", "strain_volumetric", 0.08))
    put("start_lateral_" sheared[k], value["triaxial_" sheared[k] "_100kPa", "radial_stress", 1] / 1e3)
  }
  put("start_hoop_PE", 100 * value["triaxial_PE_100kPa", "hoop_strain", 1])
  put("unordered_capacity", unordered)
  put("unordered_settlement", unordered_settlement)
  # R2 of the near-failure-state line.
  for (i = 1; i <= rows["near_failure_line"]; ++i) mean += value["near_failure_line", "distance_to_failure", i] / rows["near_failure_line"]
  for (i = 1; i <= rows["near_failure_line"]; ++i) {
    total += (value["near_failure_line", "distance_to_failure", i] - mean) ^ 2
    left += value["near_failure_line", "residual", i] ^ 2
  }
  put("nfsl", 1 - left / total)
  put("contraction_by_pressure", 100 * contraction_by_pressure)

  split("C_t p_0 n p_c kappa lambda xi p_1 p_2 alpha beta", constant, " ")
  for (k = 1; k in constant; ++k) {
    c = constant[k]
    put(c, value["constants", c, 1])
    put(c "_outside", value["constants", c "_given", 1] < value["constants", c "_low", 1] || \
      value["constants", c "_given", 1] > value["constants", c "_high", 1])
    put(c "_difference", 100 * (value["constants", c, 1] / value["constants", c "_given", 1] - 1))
  }
}
