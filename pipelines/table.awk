# An HTML table of a tab-separated one; the column "verdict" colours its cell.
# SPDX-License-Identifier: GPL-3.0-or-later
function escape(text) { gsub(/&/, "\\&amp;", text); gsub(/</, "\\&lt;", text); gsub(/>/, "\\&gt;", text); return text }
BEGIN { FS = "\t"; print "<div class=\"scroll\"><table>" }
/^#/ { next }
!header {
  header = 1
  printf "<thead><tr>"
  for (i = 1; i <= NF; ++i) { printf "<th>%s</th>", escape($i); if ($i == "verdict") verdict = i }
  print "</tr></thead><tbody>"
  next
}
{
  printf "<tr>"
  for (i = 1; i <= NF; ++i) {
    style = i == verdict ? ($i == "met" ? "met" : "unmet") : ""
    printf "<td%s>%s</td>", style ? " class=\"" style "\"" : "", escape($i)
  }
  print "</tr>"
}
END { print "</tbody></table></div>" }
