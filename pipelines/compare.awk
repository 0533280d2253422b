# Sets measured values beside published ones: met where the stated relation and tolerance hold.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk [-v partial=1] -f compare.awk expected.tsv measured.tsv
# expected.tsv: name, relation (within, at most, at least), published, tolerance, unit, source, description.
# measured.tsv: name, value, scatter. A published value that was not measured, or is no number, is an error; one of a run that is not
# made at this size has the value "none" and is left out; partial: so is what was not measured.
BEGIN {
  FS = OFS = "\t"
  print "description", "unit", "published", "tolerance", "measured", "difference", "verdict", "source"
}
/^#/ || $1 == "name" { next }
FILENAME == ARGV[1] { order[++n] = $1; line[$1] = $0; next }
{ value[$1] = $2; scatter[$1] = $3 }
END {
  for (k = 1; k <= n; ++k) {
    split(line[order[k]], e, FS)
    if (!(e[1] in value) && partial) continue
    if (!(e[1] in value)) { print "compare: " e[1] " is not in the measured values" > "/dev/stderr"; exit 1 }
    if (value[e[1]] == "none") continue
    if (value[e[1]] !~ /^[-+]?[0-9.]/) { print "compare: " e[1] " is " value[e[1]] ", not a number" > "/dev/stderr"; exit 1 }
    difference = value[e[1]] - e[3]
    size = difference < 0 ? -difference : difference
    ok = e[2] == "within" ? size <= e[4] : e[2] == "at most" ? difference <= 0 : difference >= 0
    shown = sprintf("%.4g", value[e[1]]) (scatter[e[1]] != "" ? sprintf(" ± %.2g", scatter[e[1]]) : "")
    relative = e[2] == "within" && e[3] != 0 ? sprintf(" (%+.1f %%)", 100 * difference / e[3]) : ""
    print e[7], e[5], (e[2] == "within" ? "" : e[2] " ") e[3], e[2] == "within" ? "± " e[4] : "", shown,
      sprintf("%+.3g", difference) relative, ok ? "met" : "not met", e[6]
  }
}
