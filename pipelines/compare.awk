# Sets measured values beside published ones: met where the stated relation and tolerance hold.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk [-v partial=1] -f compare.awk expected.tsv measured.tsv
# expected.tsv: name, relation (within, at most, at least), published, tolerance, unit, source, description.
# measured.tsv: name, value, scatter. A published value that was not measured, or is no number, is an error; one of a run that is not
# made at this size has the value "none" and is left out; partial: so is what was not measured.
function fail(text) { print "compare: " text > "/dev/stderr"; failed = 1; exit 1 }
# A finite number with a decimal point; inf and nan are spelt with an n by every awk.
function is_number(text) {
  return text ~ /^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?$/ && sprintf("%g", text + 0) !~ /[nN]/
}
BEGIN {
  FS = OFS = "\t"
  split("name relation published tolerance unit source description", columns, " ")
  if ("0.5" + 0 == 0) fail("this awk cuts numbers at the point in this locale; run it with LC_ALL=C.UTF-8")
  print "description", "unit", "published", "tolerance", "measured", "difference", "verdict", "source"
}
{ sub(/\r$/, "") }
FNR == 1 { sub(/^\357\273\277/, "") }
/^#/ || /^[ \t]*$/ { next }
FILENAME == ARGV[1] && !headed {
  for (k = 1; k <= 7; ++k) if ($k != columns[k]) fail(FILENAME ": column " k " is \"" $k "\" where " columns[k] " belongs")
  headed = 1
  next
}
FILENAME == ARGV[1] {
  where = FILENAME ": line " FNR ": " $1
  if (NF != 7) fail(where ": " NF " columns where 7 belong")
  if ($1 in line) fail(where ": is there twice")
  if ($2 != "within" && $2 != "at most" && $2 != "at least") fail(where ": relation \"" $2 "\"; write within, at most or at least")
  if (!is_number($3)) fail(where ": published is \"" $3 "\", not a number")
  if ($2 == "within" && !(is_number($4) && $4 >= 0)) fail(where ": tolerance is \"" $4 "\", not a number")
  order[++n] = $1
  line[$1] = $0
  next
}
$1 == "name" { next }
{ value[$1] = $2; scatter[$1] = $3 }
END {
  if (failed) exit 1
  if (!headed) fail("no header line in the expected values")
  for (k = 1; k <= n; ++k) {
    split(line[order[k]], e, FS)
    if (!(e[1] in value) && partial) continue
    if (!(e[1] in value)) fail(e[1] " is not in the measured values")
    if (value[e[1]] == "none") continue
    if (!is_number(value[e[1]])) fail(e[1] " is " value[e[1]] ", not a number")
    difference = value[e[1]] - e[3]
    size = difference < 0 ? -difference : difference
    ok = e[2] == "within" ? size <= e[4] : e[2] == "at most" ? difference <= 0 : difference >= 0
    shown = sprintf("%.4g", value[e[1]]) (scatter[e[1]] != "" ? sprintf(" ± %.2g", scatter[e[1]]) : "")
    relative = e[2] == "within" && e[3] != 0 ? sprintf(" (%+.1f %%)", 100 * difference / e[3]) : ""
    print e[7], e[5], (e[2] == "within" ? "" : e[2] " ") e[3], e[2] == "within" ? "± " e[4] : "", shown,
      sprintf("%+.3g", difference) relative, ok ? "met" : "not met", e[6]
  }
}
