# The numbers of chapter 3: generation, compression beside the recorded series of the same model, shear, strips.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -v loads='1330 ...' -v yarns=1 -f measure.awk uc_*.tsv uc_*_fabric.tsv uc_PE_groups.tsv ss_*.tsv strip_*.tsv box_*.tsv generation.tsv soilbag_uniaxial_*.tsv > measured.tsv
# value[file, column, row] in SI; rows[file]. Files are named by their last part without the ending. yarns: how many of the record's
# yarns one of these stands for.
function name_of(path) { sub(/.*\//, "", path); sub(/\.tsv$/, "", path); return path }
function factor(unit) { return unit == "%" ? 0.01 : unit ~ /^k/ ? 1000 : 1 }
function size(x) { return x < 0 ? -x : x }
function put(name, number) { printf "%s\t%.6g\t\n", name, number }
function last(file, column) { return value[file, column, rows[file]] }

# The column y of a file where its column x first reaches `at`, straight between rows; its last value where it never does.
function where(file, x, y, at, i) {
  for (i = 2; i <= rows[file]; ++i)
    if (value[file, x, i] >= at)
      return value[file, y, i - 1] + (value[file, y, i] - value[file, y, i - 1]) * (at - value[file, x, i - 1]) / \
        (value[file, x, i] - value[file, x, i - 1])
  return last(file, y)
}
function greatest(file, column, i, row) {
  row = 1
  for (i = 2; i <= rows[file]; ++i) if (value[file, column, i] > value[file, column, row]) row = i
  return row
}

# Axial strain from the end of the preload, whose row it returns; load over 0.16 m2.
function compression(f, i, start) {
  for (start = 1; start < rows[f] && value[f, "stage", start + 1] == 0; ++start) { }
  for (i = 1; i <= rows[f]; ++i) {
    value[f, "strain", i] = (value[f, "displacement_bottom_z", i] - value[f, "displacement_top_z", i] - \
      value[f, "displacement_bottom_z", start] + value[f, "displacement_top_z", start]) / 0.08
    value[f, "pressure", i] = 0.5 * (size(value[f, "force_top_z", i]) + size(value[f, "force_bottom_z", i])) / 0.16
    value[f, "tension", i] = value[f, "yarn_tension_face", i] / yarns
    value[f, "lateral", i] = 0.5 * (value[f, "soil_stress_xx", i] + value[f, "soil_stress_yy", i])
  }
  return start
}

# The step of the state recorded at that strain, and an anisotropy there.
function step_at(g, strain, i) {
  for (i = 1; i <= rows["uc_" g]; ++i) if (size(value["uc_" g, "strain", i] - strain) < 1e-3) return value["uc_" g, "step", i]
}
function anisotropy(g, kind, strain, k) {
  for (k = 1; k <= rows["uc_" g "_fabric"]; ++k)
    if (value["uc_" g "_fabric", "step", k] == step_at(g, strain)) return value["uc_" g "_fabric", kind, k]
}
# Mean stress in the group of copies in the middle over that of the outermost one, #1.
function middle_over_edge(g, strain, k, n, p) {
  for (k = 1; k <= rows["uc_" g "_groups"]; ++k)
    if (value["uc_" g "_groups", "step", k] == step_at(g, strain)) p[n++] = value["uc_" g "_groups", "mean_stress", k]
  return p[int(n / 2)] / p[0]
}

# One geotextile beside its recorded series.
function compare(g, f, r, i, at, base, peak, recorded, tautest, densest, start, pq, pp) {
  f = "uc_" g; r = "soilbag_uniaxial_" g
  start = compression(f)
  densest = start
  for (i = start; i <= rows[f]; ++i) if (value[f, "soil_void_ratio", i] < value[f, "soil_void_ratio", densest]) densest = i
  put("contraction_" g, value[f, "soil_void_ratio", start] - value[f, "soil_void_ratio", densest])
  for (i = 1; i <= rows[f]; ++i) if (value[f, "broken_yarns", i] > 0) break
  put("first_break_" g, 100 * value[f, "strain", i < rows[f] ? i : rows[f]])
  base = i < rows[f] ? i : rows[f]
  at_break[g] = value[f, "soil_deviatoric_stress", base] / value[f, "soil_mean_stress", base]
  put("obliquity_" g, at_break[g])
  put("obliquity_ratio_" g, at_break[g] / \
    (where(r, "strain_axial", "deviatoric_stress", value[f, "strain", base]) / where(r, "strain_axial", "mean_stress", value[f, "strain", base])))
  peak = greatest(f, "soil_stress_zz"); recorded = greatest(r, "axial_stress")
  put("peak_axial_" g, value[f, "soil_stress_zz", peak] / 1000)
  put("peak_pressure_" g, value[f, "pressure", greatest(f, "pressure")] / 1000)
  put("peak_strain_" g, 100 * value[f, "strain", peak])
  # Slope of the path in p and q up to there, through the origin.
  for (i = start; i <= base; ++i) {
    pq += value[f, "soil_mean_stress", i] * value[f, "soil_deviatoric_stress", i]
    pp += value[f, "soil_mean_stress", i] ^ 2
  }
  put("path_slope_" g, pq / pp)
  # Greatest differences up to the recorded peak: at equal tension of the yarns on the faces, or at the greatest where that is never
  # reached; the same up to the first break, before strength has its part; and from 3 % on at equal strain.
  tautest = value[f, "tension", greatest(f, "tension")]
  for (i = 2; i <= recorded; ++i) {
    at = value[r, "tension_yarn_face", i]
    if (at > tautest) at = tautest
    note("tension", g, "lateral", where(f, "tension", "lateral", at), value[r, "radial_stress", i])
    note("tension", g, "axial", where(f, "tension", "soil_stress_zz", at), value[r, "axial_stress", i])
    note("tension", g, "pressure", where(f, "tension", "pressure", at), value[r, "plate_pressure", i])
    if (at <= value[f, "tension", base]) {
      note("unbroken", g, "lateral", where(f, "tension", "lateral", at), value[r, "radial_stress", i])
      note("unbroken", g, "axial", where(f, "tension", "soil_stress_zz", at), value[r, "axial_stress", i])
      note("unbroken", g, "pressure", where(f, "tension", "pressure", at), value[r, "plate_pressure", i])
    }
    if (value[r, "strain_axial", i] < 0.03) continue
    at = value[r, "strain_axial", i]
    note("strain", g, "lateral", where(f, "strain", "lateral", at), value[r, "radial_stress", i])
    note("strain", g, "axial", where(f, "strain", "soil_stress_zz", at), value[r, "axial_stress", i])
    note("strain", g, "pressure", where(f, "strain", "pressure", at), value[r, "plate_pressure", i])
    note("strain", g, "tension", where(f, "strain", "tension", at), value[r, "tension_yarn_face", i])
  }
  # Energy that the balance leaves over, of the work of the plates.
  put("energy_error_" g, 100 * size(last(f, "energy_error")) / size(last(f, "boundary_work")))
  put("tension_families_" g, value[f, "yarn_tension_face", base] / value[f, "yarn_tension_side_horizontal", base])
  put("hoop_over_side_" g, value[f, "yarn_tension_side_horizontal", base] / value[f, "yarn_tension_side_vertical", base])
  put("face_friction_" g, value[f, "face_friction_z", base])
}
# Of a bag under the k-th load: the greatest shear ratio; how much thinner and then thicker it grows, mm; lateral and axial stress of the
# soil at the greatest ratio over those before the shear; tension of the sides over that of the faces there.
function shear(k, f, first, i, peak, lowest) {
  for (first = 1; value[f, "stage", first + 1] == 0; ++first) { }
  peak = lowest = first
  for (i = first; i <= rows[f]; ++i) {
    if (size(value[f, "force_top_x", i]) > size(value[f, "force_top_x", peak])) peak = i
    if (value[f, "displacement_top_z", i] < value[f, "displacement_top_z", lowest]) lowest = i
  }
  ratio[k] = size(value[f, "force_top_x", peak]) / size(value[f, "force_top_z", peak])
  contracted[k] = 1000 * (value[f, "displacement_top_z", first] - value[f, "displacement_top_z", lowest])
  dilated[k] = 1000 * (last(f, "displacement_top_z") - value[f, "displacement_top_z", lowest])
  lateral[k] = (value[f, "soil_stress_xx", peak] + value[f, "soil_stress_yy", peak]) / \
    (value[f, "soil_stress_xx", first] + value[f, "soil_stress_yy", first])
  axial[k] = value[f, "soil_stress_zz", peak] / value[f, "soil_stress_zz", first]
  sides[k] = 0.5 * (value[f, "yarn_tension_side_horizontal", peak] + value[f, "yarn_tension_side_vertical", peak]) / \
    value[f, "yarn_tension_face", peak]
}
# Friction angle of the interface in a shear box, deg: walls push by what the sheet holds back; mean of the second half of the way.
function interface(f, i, across, normal) {
  for (i = int(rows[f] / 2) + 1; i <= rows[f]; ++i) {
    across += size(value[f, "force_left_x", i] + value[f, "force_right_x", i])
    normal += size(value[f, "force_lid_z", i])
  }
  return atan2(across, normal) * 180 / 3.14159265358979
}
function note(at, g, what, measured, recorded, d, key) {
  d = 100 * (measured / recorded - 1)
  key = "equal_" at "_" what "_" g
  if (size(d) > size(misfit[key])) misfit[key] = d
}

FNR == 1 { file = name_of(FILENAME); head = 0 }
/^#/ { next }
!head {
  head = 1
  n = split($0, title, "\t")
  for (k = 1; k <= n; ++k) {
    unit[k] = title[k]; sub(/.*\[/, "", unit[k]); sub(/\].*/, "", unit[k])
    sub(/ *\[.*/, "", title[k])
  }
  next
}
{
  split($0, field, "\t")
  ++rows[file]
  for (k = 1; k <= n; ++k) value[file, title[k], rows[file]] = field[k] * factor(unit[k])
}
END {
  put("void_ratio", last("generation", "void_ratio"))
  put("delaunay_void_ratio", last("generation", "delaunay_void_ratio"))
  put("coordination_number", last("generation", "coordination_number"))
  compare("PE"); compare("PP")
  # From 4 % to beyond the first breaks.
  put("anisotropy_c_rises_PE", anisotropy("PE", "a_c", 0.12) - anisotropy("PE", "a_c", 0.04))
  put("anisotropy_n_falls_PE", anisotropy("PE", "a_n", 0.12) - anisotropy("PE", "a_n", 0.04))
  put("anisotropy_t_falls_PE", anisotropy("PE", "a_t", 0.12) - anisotropy("PE", "a_t", 0.04))
  put("anisotropy_c_PP_over_PE", anisotropy("PP", "a_c", 0.08) / anisotropy("PE", "a_c", 0.08))
  put("anisotropy_n_PP_over_PE", anisotropy("PP", "a_n", 0.08) / anisotropy("PE", "a_n", 0.08))
  put("anisotropy_t_PP_over_PE", anisotropy("PP", "a_t", 0.08) / anisotropy("PE", "a_t", 0.08))
  put("middle_over_edge_PE", middle_over_edge("PE", 0.12))
  put("obliquity_PP_over_PE", at_break["PP"] / at_break["PE"])
  for (key in misfit) put(key, misfit[key])
  # Strips: 5 yarns side by side, 100 mm long.
  split("PE PP", fabrics, " ")
  split("4.2 15", initial, " ")
  for (k = 1; k <= 2; ++k) {
    f = "strip_" fabrics[k]
    put("strip_stiffness_" fabrics[k], size(value[f, "force_right_y", 2]) / 5 / initial[k])
    put("strip_strength_" fabrics[k], size(value[f, "force_right_y", greatest(f, "yarn_tension_face")]) / 5)
  }
  put("box_friction_21", interface("box_21"))
  put("box_friction_25", interface("box_25"))
  put("box_friction_rises", interface("box_25") - interface("box_21"))
  m = split(loads, load, " ")
  for (k = 1; k <= m; ++k) shear(k, "ss_" load[k])
  f = "ss_" load[1]
  put("shear_contraction", contracted[1])
  put("shear_dilation", dilated[1])
  put("shear_lag", size(last(f, "soil_stress_xz")) / last(f, "soil_stress_zz") - size(last(f, "force_top_x")) / size(last(f, "force_top_z")))
  put("shear_ratio_first", ratio[1])
  put("shear_ratio_last", ratio[m])
  put("shear_ratio_falls", ratio[m] - ratio[1])
  put("shear_dilation_falls", dilated[m] - dilated[1])
  put("shear_lateral", lateral[m])
  put("shear_axial", axial[m])
  put("shear_sides_over_faces", sides[m])
}
