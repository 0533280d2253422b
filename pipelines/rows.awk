# The rows of an ensemble's table as the scripts read them: below one header line, with line feeds alone, without comments and
# empty lines, ids without leading zeros. Refuses a row without a whole id or with too few columns.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: file=TABLE awk [-v columns=6] -f rows.awk < TABLE
function fail(text) { print "rows: " ENVIRON["file"] ": line " NR ": " text > "/dev/stderr"; failed = 1; exit 65 }
BEGIN { FS = "\t"; RS = "\r\n|\n|\r" }
{ sub(/^\357\273\277/, "") }
/^#/ || /^[ \t]*$/ { next }
!headed {
  if ($1 !~ /^id( \[1\])?$/) fail("the first column is \"" $1 "\" where id belongs; columns are separated by tabs")
  if (NF < columns) fail(NF " columns where " columns " belong, separated by tabs")
  headed = NF
  print
  next
}
{
  if (NF != headed) fail(NF " values where the header names " headed " columns, separated by tabs")
  id = $1
  if (id !~ /^[0-9]+$/) fail("id \"" id "\" is no whole number")
  sub(/^0+/, "", id)
  if (id == "") id = "0"
  if (id in seen) fail("id " id " is there twice")
  seen[id] = 1
  for (k = 2; k <= NF; ++k) if ($k !~ /^[^,]+$/) fail("\"" $k "\" in column " k " is no number; write it with a decimal point")
  print id substr($0, length($1) + 1)
}
END { if (!failed && !headed) fail("no header line that begins with id") }
