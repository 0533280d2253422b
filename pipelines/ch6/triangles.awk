# The triangles of the structured mesh with what their points say, at the last time: a corner a row, blank lines between.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: awk -v squares=8 -v names='mean_stress ...' -f triangles.awk NODES POINTS
BEGIN { FS = OFS = "\t"; count = split(names, wanted, " ") }
FNR == 1 {
  ++file
  delete at
  for (i = 1; i <= NF; ++i) { name = $i; sub(/ \[.*/, "", name); at[name] = i; heading[file, name] = $i }
  next
}
file == 1 { x[$at["node"] + 0] = $at["x"]; y[$at["node"] + 0] = $at["y"]; next }
{ for (k = 1; k <= count; ++k) value[$at["element"] + 0, k] = $at[wanted[k]]; elements = $at["element"] + 1 }
function corner(node, element,   k) {
  printf "%s\t%s", x[node], y[node]
  for (k = 1; k <= count; ++k) printf "\t%s", value[element, k]
  printf "\n"
}
END {
  if (elements != 2 * squares * squares) { print "triangles: the mesh is not of 2 x " squares " x " squares " elements" > "/dev/stderr"; exit 1 }
  printf "%s\t%s", heading[1, "x"], heading[1, "y"]
  for (k = 1; k <= count; ++k) printf "\t%s", heading[2, wanted[k]]
  printf "\n"
  for (e = 0; e < elements; ++e) {
    i = int(e / 2) % squares; j = int(e / 2 / squares)
    a = j * (squares + 1) + i; b = a + 1; d = a + squares + 1; c = d + 1
    corner(e % 2 ? b : a, e); corner(e % 2 ? c : b, e); corner(d, e)
    printf "\n"
  }
}
