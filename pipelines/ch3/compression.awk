# Chapter 3, uniaxial compression: bags of PE and PP beside the recorded series of the same model; loaded after measure.awk.
# SPDX-License-Identifier: GPL-3.0-or-later

function of_bag(key) { return 1e-3 * setting("pipelines/ch3/bag.toml", key) }
# Volume inside the surface that is parallel to the bag's so far beyond it (Cushion, lib/packing/cushion.h).
function bag_volume(beyond, half, side, h, s, core, r, round) {
  half = of_bag("half_height"); side = of_bag("side_radius")
  h = half + beyond; s = side + beyond
  core = of_bag("width") / 2 - sqrt(side ^ 2 - half ^ 2); r = of_bag("corner_radius") + beyond
  round = (h * sqrt(s ^ 2 - h ^ 2) + s ^ 2 * atan2(h, sqrt(s ^ 2 - h ^ 2))) / 2
  return 8 * (core ^ 2 * h + 2 * core * round + h * (s ^ 2 - h ^ 2 / 3)) - 2 * h * (4 - atan2(0, -1)) * r ^ 2
}

# Axial strain from the end of the preload, whose row it returns; load over 0.16 m2; surcharge, the stress of soil and geotextile as
# one, which the plates balance. Soil ends a node's radius inside the surface, however large the nodes.
function compression(f, i, start, height, node, layer) {
  need(f, "soil_delaunay_void_ratio")
  for (start = 1; start < rows[f] && value[f, "stage", start + 1] == 0; ++start) { }
  node = of_bag("node_radius")
  layer = bag_volume(node * (2 * yarns - 1)) - bag_volume(-node)
  for (i = 1; i <= rows[f]; ++i) {
    height = value[f, "displacement_top_z", i] - value[f, "displacement_bottom_z", i]
    value[f, "strain", i] = (value[f, "displacement_top_z", start] - value[f, "displacement_bottom_z", start] - height) / 0.08
    value[f, "pressure", i] = 0.5 * (size(value[f, "force_top_z", i]) + size(value[f, "force_bottom_z", i])) / 0.16
    value[f, "surcharge", i] = value[f, "pressure", i] * 0.16 * (0.08 + 2 * node * (2 * yarns - 1) + height) / (value[f, "soil_volume", i] + layer)
    value[f, "tension", i] = value[f, "yarn_tension_face", i] / yarns
    value[f, "lateral", i] = 0.5 * (value[f, "soil_stress_xx", i] + value[f, "soil_stress_yy", i])
    value[f, "around", i] = around(value[f, "tension", i], value[f, "yarn_tension_side_horizontal", i] / yarns)
  }
  return start
}
# Mean tension of the yarns that a plane in the middle cuts, which balance the lateral stress: 91 on each face, 20 on each side.
function around(face, side) { return (91 * face + 20 * side) / 111 }
# How much of what the faces' yarns stretch the horizontal ones of the sides do: how soon and how far the sides share in holding the soil.
function side_share(f, strain) { return where(f, "strain", "yarn_strain_side_horizontal", strain) / where(f, "strain", "yarn_strain_face", strain) }
# Its row of the first broken yarn, or the last.
function broken_row(f, i) {
  for (i = 1; i < rows[f]; ++i) if (value[f, "broken_yarns", i] > 0) break
  return i
}
# The strain at which its first yarn broke: towards each station plates move at the study's rate, then they wait for rest.
function first_break(f, i, first, rate) {
  if (!rows[f "_first_break"]) return "none"
  rate = setting("pipelines/ch3/uc.toml", "rate")
  first = value[f "_first_break", "break_time", 1]
  for (i = 2; i < rows[f] && value[f, "time", i] < first; ++i) { }
  return 100 * smaller(value[f, "strain", i], value[f, "strain", i - 1] + rate * (first - value[f, "time", i - 1]))
}
# The last row whose load is within 2 % of the greatest: where the bag fails, unless it is the last of all.
function failure_row(f, i) {
  for (i = rows[f]; value[f, "pressure", i] < 0.98 * value[f, "pressure", greatest(f, "pressure")]; --i) { }
  return i
}
# The path in p and q from row to row: slope through the origin, and the greatest distance from that line over the greatest q.
function path_slope(f, p, q, from, to, i, pq, pp) {
  for (i = from; i <= to; ++i) { pq += value[f, p, i] * value[f, q, i]; pp += value[f, p, i] ^ 2 }
  return pq / pp
}
function path_deviation(f, p, q, from, to, slope, i, d) {
  slope = path_slope(f, p, q, from, to)
  for (i = from; i <= to; ++i) d = larger(d, size(value[f, q, i] - slope * value[f, p, i]))
  return d / value[f, q, to]
}
# The same of the groups, the greatest: states after the preload up to that step.
function groups_deviation(f, start, end, i, k, group, d) {
  for (i = 1; i <= rows[f]; ++i) {
    if (value[f, "step", i] < start || value[f, "step", i] > end) continue
    k = f "_" value[f, "volume_of_interest", i]
    ++rows[k]; group[k]
    value[k, "p", rows[k]] = value[f, "mean_stress", i]
    value[k, "q", rows[k]] = value[f, "deviatoric_stress", i]
  }
  for (k in group) d = larger(d, path_deviation(k, "p", "q", 1, rows[k]))
  return d
}

# The step of the state recorded at that strain, and an anisotropy there.
function step_at(g, strain, i) {
  for (i = 1; i <= rows["uc_" g]; ++i) if (size(value["uc_" g, "strain", i] - strain) < 1e-3) return value["uc_" g, "step", i]
}
function anisotropy(g, kind, strain) { return at_step("uc_" g "_fabric", kind, step_at(g, strain)) }

# Greatest differences up to the recorded peak: at equal tension of the yarns on the faces, or at the greatest where that is never
# reached; the same up to the first break, before strength has its part; and from 3 % on at equal strain. What was recorded before the
# bag's own first station is left out: between the preload and that station stresses are no straight line.
function keep_greatest(key, d) { if (size(d) > size(misfit[key])) misfit[key] = d }
function note(at, g, what, measured, recorded) { keep_greatest("equal_" at "_" what "_" g, 100 * (measured / recorded - 1)) }
# Those of the stresses where a column of ours is as large as at that row of the record.
function note_stresses(at, g, f, column, here, r, i) {
  note(at, g, "lateral", where(f, column, "lateral", here), value[r, "radial_stress", i])
  note(at, g, "axial", where(f, column, "soil_stress_zz", here), value[r, "axial_stress", i])
  note(at, g, "pressure", where(f, column, "pressure", here), value[r, "plate_pressure", i])
}
function first_beside_record(f, r, i, first) {
  for (first = 1; first < rows[f] && value[f, "stage", first] == 0; ++first) { }
  for (i = 1; i < rows[r] && value[r, "tension_yarn_face", i] < value[f, "tension", first]; ++i) { }
  return i
}
function unbroken_beside_record(g, f, r, base, i) {
  for (i = first_beside_record(f, r); i <= rows[r] && value[r, "tension_yarn_face", i] <= value[f, "tension", base]; ++i)
    note_stresses("unbroken", g, f, "tension", value[r, "tension_yarn_face", i], r, i)
}
# Volumetric strain, dilation positive, of the block between the faces, whose yarns stretch as it is pressed flat: without the sides, and
# without the Delaunay tetrahedra that span what is hollow there.
function between_faces(x, x0, axial) { return 2 * (x - x0) - axial }
function note_block(g, f, r, at, i) {
  keep_greatest("equal_strain_block_" g, \
    100 * (between_faces(where(f, "strain", "yarn_strain_face", at), where(f, "strain", "yarn_strain_face", 0), at) - \
    between_faces(value[r, "strain_yarn_face", i], value[r, "strain_yarn_face", 1], at)))
}
function note_around(g, f, r, i, recorded) {
  recorded = around(value[r, "tension_yarn_face", i], value[r, "tension_yarn_horizontal", i])
  note("around", g, "lateral", where(f, "around", "lateral", smaller(recorded, value[f, "around", greatest(f, "around")])), value[r, "radial_stress", i])
}
function beside_record(g, f, r, i, at, recorded, tautest) {
  recorded = greatest(r, "axial_stress")
  tautest = value[f, "tension", greatest(f, "tension")]
  for (i = first_beside_record(f, r); i <= recorded; ++i) {
    note_stresses("tension", g, f, "tension", smaller(value[r, "tension_yarn_face", i], tautest), r, i)
    note_around(g, f, r, i)
    at = value[r, "strain_axial", i]
    if (at < 0.03) continue
    note_stresses("strain", g, f, "strain", at, r, i)
    note("strain", g, "tension", where(f, "strain", "tension", at), value[r, "tension_yarn_face", i])
    note_block(g, f, r, at, i)
  }
}
# What is left of a stress at the last strain over what is left of the recorded one there, each of its greatest.
function left_over(f, column, r, recorded) {
  return last(f, column) / value[f, column, greatest(f, column)] / \
    (where(r, "strain_axial", recorded, last(f, "strain")) / value[r, recorded, greatest(r, recorded)])
}

# The greatest of a column and the strain of it, unless it is the last and may be no peak.
function put_peak(name, name_of_strain, f, column, i) {
  i = greatest(f, column)
  put(name, i < rows[f] ? value[f, column, i] / 1000 : "none")
  if (name_of_strain) put(name_of_strain, i < rows[f] ? 100 * value[f, "strain", i] : "none")
}
function loads_and_strains(g, f, r) {
  put("first_break_" g, first_break(f))
  put_peak("peak_axial_" g, "peak_strain_" g, f, "soil_stress_zz")
  put_peak("peak_lateral_" g, "", f, "lateral")
  put_peak("peak_pressure_" g, "peak_pressure_strain_" g, f, "pressure")
  put("failure_strain_" g, 100 * value[f, "strain", failure_row(f)])
  # Energy that the balance leaves over, of the work of the plates.
  put("energy_error_" g, 100 * size(last(f, "energy_error")) / size(last(f, "boundary_work")))
  put("left_axial_" g, failure_row(f) < rows[f] ? left_over(f, "soil_stress_zz", r, "axial_stress") : "none")
  put("left_pressure_" g, failure_row(f) < rows[f] ? left_over(f, "pressure", r, "plate_pressure") : "none")
  put("left_lateral_" g, failure_row(f) < rows[f] ? left_over(f, "lateral", r, "radial_stress") : "none")
}
function volume_change(g, f, start, base, i, densest) {
  densest = start
  for (i = start; i <= rows[f]; ++i) if (value[f, "soil_delaunay_void_ratio", i] < value[f, "soil_delaunay_void_ratio", densest]) densest = i
  put("contraction_" g, value[f, "soil_delaunay_void_ratio", start] - value[f, "soil_delaunay_void_ratio", densest])
  put("densest_strain_" g, 100 * value[f, "strain", densest])
  put("dilation_" g, where(f, "strain", "soil_delaunay_void_ratio", 0.12) - value[f, "soil_delaunay_void_ratio", densest])
  put("void_ratio_at_break_" g, value[f, "soil_delaunay_void_ratio", base] - value[f, "soil_delaunay_void_ratio", start])
}
# q/p over the recorded one at that strain.
function obliquity_ratio(f, r, strain) {
  return where(f, "strain", "soil_obliquity", strain) / \
    (where(r, "strain_axial", "deviatoric_stress", strain) / where(r, "strain_axial", "mean_stress", strain))
}
function slopes(g, f, r, start, base) {
  at_break[g] = value[f, "soil_obliquity", base]
  put("obliquity_" g, at_break[g])
  put("obliquity_ratio_" g, obliquity_ratio(f, r, value[f, "strain", base]))
  put("toe_obliquity_ratio_" g, obliquity_ratio(f, r, 0.02))
  put("path_slope_" g, path_slope(f, "soil_mean_stress", "soil_deviatoric_stress", start, base))
  put("path_deviation_" g, path_deviation(f, "soil_mean_stress", "soil_deviatoric_stress", start, base))
}
function paths(g, f, start, base, i, obliquity, least) {
  put("groups_deviation_" g, groups_deviation(f "_groups", value[f, "step", start], value[f, "step", base]))
  least = 1e9
  for (i = start; i <= rows[f]; ++i) {
    obliquity = larger(obliquity, value[f, "soil_obliquity", i])
    least = smaller(least, value[f, "soil_stress_zz", i] / value[f, "surcharge", i])
  }
  put("greatest_obliquity_" g, obliquity)
  put("axial_over_surcharge_" g, least)
  put("middle_p_" g, middle_over_edge(f "_groups", "mean_stress", step_at(g, 0.08)))
  put("middle_q_" g, middle_over_edge(f "_groups", "deviatoric_stress", step_at(g, 0.08)))
  put("middle_at_peak_" g, middle_over_edge(f "_groups", "mean_stress", step_at(g, 0.12)))
  put("middle_evens_out_" g, last(f, "strain") > 0.19 ? \
    middle_over_edge(f "_groups", "mean_stress", last(f, "step")) - middle_over_edge(f "_groups", "mean_stress", step_at(g, 0.12)) : "none")
}
function yarns_and_faces(g, f, start, base, i, most, sides) {
  put("side_share_toe_" g, side_share(f, 0.03))
  put("side_share_" g, side_share(f, 0.10))
  put("tension_families_" g, value[f, "yarn_tension_face", base] / value[f, "yarn_tension_side_horizontal", base])
  put("hoop_over_side_" g, value[f, "yarn_tension_side_horizontal", base] / value[f, "yarn_tension_side_vertical", base])
  for (i = start + 1; i <= rows[f]; ++i) {
    value[f, "face_friction_sides", i] = larger(value[f, "face_friction_x", i], value[f, "face_friction_y", i])
    most = larger(most, larger(value[f, "face_friction_sides", i], value[f, "face_friction_z", i]))
  }
  put("face_friction_" g, most)
  sides = value[f, "face_friction_sides", base] / value[f, "face_friction_z", base]
  put("face_friction_z_over_sides_" g, 1 / sides)
  put("face_friction_sides_over_z_" g, sides)
  put("face_friction_z_rises_" g, rises(f, "face_friction_z", start, base))
  put("face_friction_sides_rises_" g, rises(f, "face_friction_sides", start, base))
}
# Mean of a column after failure less that up to the first break.
function rises(f, column, start, base, i, failed, before, after) {
  failed = failure_row(f)
  if (failed == rows[f]) return "none"
  for (i = start + 1; i <= base; ++i) before += value[f, column, i] / (base - start)
  for (i = failed + 1; i <= rows[f]; ++i) after += value[f, column, i] / (rows[f] - failed)
  return after - before
}
# Anisotropies from 4 % over the first breaks at 8 to 10 % to the end.
function anisotropies(g) {
  put("anisotropy_c_rises_" g, anisotropy(g, "a_c", 0.08) - anisotropy(g, "a_c", 0.04))
  put("anisotropy_c_stagnates_" g, anisotropy(g, "a_c", 0.12) - 2 * anisotropy(g, "a_c", 0.08) + anisotropy(g, "a_c", 0.04))
  put("anisotropy_c_falls_later_" g, last("uc_" g, "strain") > 0.19 ? last("uc_" g "_fabric", "a_c") - anisotropy(g, "a_c", 0.12) : "none")
  put("anisotropy_n_falls_" g, anisotropy(g, "a_n", 0.12) - anisotropy(g, "a_n", 0.04))
  put("anisotropy_t_falls_" g, anisotropy(g, "a_t", 0.12) - anisotropy(g, "a_t", 0.04))
}
# Where yarns broke: mean nearness to the seam.
function seam(file, i, sum) {
  for (i = 1; i <= rows[file]; ++i) sum += value[file, "seam", i]
  return rows[file] ? sum / rows[file] : "none"
}

END {
  for (k = 1; k <= 2; ++k) {
    g = fabrics[k]
    f = "uc_" g; r = "soilbag_uniaxial_" g
    if (!rows[f]) continue
    start = compression(f)
    base = broken_row(f)
    loads_and_strains(g, f, r)
    volume_change(g, f, start, base)
    slopes(g, f, r, start, base)
    beside_record(g, f, r)
    unbroken_beside_record(g, f, r, base)
    paths(g, f, start, base)
    yarns_and_faces(g, f, start, base)
    anisotropies(g)
  }
  for (key in misfit) put(key, misfit[key])
  both = rows["uc_PE"] && rows["uc_PP"]
  if (both) put("obliquity_PP_over_PE", at_break["PP"] / at_break["PE"])
  for (k = 1; both && k <= split("c n t", kinds, " "); ++k)
    put("anisotropy_" kinds[k] "_PP_over_PE", anisotropy("PP", "a_" kinds[k], 0.08) / anisotropy("PE", "a_" kinds[k], 0.08))
  put("breaks_smooth", seam("uc_PE_breaks"))
  put("breaks_rough", seam("uc_PE_rough_breaks"))
}
