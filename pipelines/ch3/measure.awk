# The numbers of chapter 3: what is read and what both kinds of loading need; generation, strips, shear box. compression.awk and
# shear.awk add theirs.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -v loads='1330 ...' -v yarns=1 -f measure.awk -f compression.awk -f shear.awk uc_*.tsv ss_*.tsv strip_*.tsv box_*.tsv
#   generation.tsv shape.tsv soilbag_uniaxial_*.tsv > measured.tsv
# value[file, column, row] in SI; rows[file]. Files are named by their last part without the ending. yarns: how many of the record's
# yarns one of these stands for. What a run that is missing would tell is left out.
function name_of(path) { sub(/.*\//, "", path); sub(/\.tsv$/, "", path); return path }
function factor(unit) { return unit == "%" ? 0.01 : unit ~ /^k/ ? 1000 : 1 }
function size(x) { return x < 0 ? -x : x }
function larger(x, y) { return x > y ? x : y }
function smaller(x, y) { return x < y ? x : y }
function put(name, number) { if (number == "none") print name, number; else printf "%s\t%.6g\t\n", name, number }
function last(file, column) { return value[file, column, rows[file]] }
# Of a run whose tables are there in part alone, nothing is told.
function need(file, column) {
  if ((file, column, 1) in value) return
  print "measure: no " column " of " file ": make its tables anew" > "/dev/stderr"
  exit 1
}
# The number of a key of a TOML file, in its unit there; of a list the first.
function setting(file, key, line) {
  while ((getline line < file) > 0)
    if (line ~ "^" key " *=") { close(file); sub(/^[^=]*= *["\[]*/, "", line); return line + 0 }
  print "measure: no " key " in " file > "/dev/stderr"
  exit 1
}

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
# The column in the row of that step.
function at_step(file, column, step, i) {
  for (i = 1; i <= rows[file]; ++i) if (value[file, "step", i] == step) return value[file, column, i]
}
# The column of groups of copies along x at that step, mean of the outermost, #1 and #5, or of those between.
function of_groups(file, column, step, middle, i, k, n, sum, count) {
  for (i = 1; i <= rows[file]; ++i) if (value[file, "step", i] == step) n = value[file, "volume_of_interest", i] + 1
  for (i = 1; i <= rows[file]; ++i) {
    k = value[file, "volume_of_interest", i]
    if (value[file, "step", i] == step && (k > 0 && k < n - 1) == middle) { sum += value[file, column, i]; ++count }
  }
  return sum / count
}
function middle_over_edge(file, column, step) { return of_groups(file, column, step, 1) / of_groups(file, column, step, 0) }

# Friction angle of the interface in a shear box, deg: walls push by what the sheet holds back; mean of the second half of the way.
function interface(f, i, across, normal) {
  for (i = int(rows[f] / 2) + 1; i <= rows[f]; ++i) {
    across += size(value[f, "force_left_x", i] + value[f, "force_right_x", i])
    normal += size(value[f, "force_lid_z", i])
  }
  return atan2(across, normal) * 180 / 3.14159265358979
}

BEGIN { OFS = "\t" }
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
  if (rows["generation"]) {
    put("delaunay_void_ratio", last("generation", "delaunay_void_ratio"))
    put("coordination_number", last("generation", "coordination_number"))
  }
  if (rows["shape"]) {
    put("spheres", yarns == 1 ? value["shape", "bag", 1] : "none")
    m = split("contact_number orientation soil_contact_number soil_orientation", what, " ")
    for (k = 1; k <= m; ++k) put(what[k], value["shape", "distance", k] / value["shape", "distance of samples", k])
  }
  # Strips: 5 yarns side by side, 100 mm long.
  split("PE PP", fabrics, " ")
  for (k = 1; k <= 2; ++k) {
    f = "strip_" fabrics[k]
    if (!rows[f]) continue
    curve = "data/geotextiles/" fabrics[k] ".toml"
    put("strip_stiffness_" fabrics[k], size(value[f, "force_right_y", 2]) / 5 / (0.01 * setting(curve, "yarn_tension") / setting(curve, "yarn_strain")))
    put("strip_strength_" fabrics[k], size(value[f, "force_right_y", greatest(f, "yarn_tension_face")]) / 5)
  }
  if (rows["box_21"] && rows["box_25"]) {
    put("box_friction_21", interface("box_21"))
    put("box_friction_25", interface("box_25"))
    put("box_friction_rises", interface("box_25") - interface("box_21"))
  }
}
