#!/bin/sh
# The quickstart's section of the report, on standard output.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: OUT=out/quickstart page.sh > page.html
set -eu
# shellcheck source=pipelines/figure.sh
. "$(dirname "$0")/../figure.sh"

runs=$(awk 'NR > 1' "$OUT/runs.tsv" | wc -l)
packings=$(awk -F '\t' 'NR > 1 { print $2 }' "$OUT/runs.tsv" | sort -u | wc -l)

cat <<PAGE
<section id="quickstart">
<h2>Toyoura sand, from a grading curve to triaxial tests</h2>
<p>1000 spheres follow the grading of Toyoura sand, are brought to a void ratio of 0.68 at 1 kPa, nearly free of force, compressed
isotropically to 0.2, 0.5 and 1.0 MPa and sheared in drained triaxial compression with the Hertz–Mindlin parameters of thesis
Table 3.1, at 3 % a second instead of 10, which is slow enough for the rate not to matter: $runs runs of $packings packings, made alike
from the seeds 1 to $packings, for so few grains carry more in one packing than in the next. Numbers are means of what each packing has,
curves means at equal strain, ± and bands the standard deviation over the packings.</p>
<h3>Measured beside published</h3>
PAGE
awk -f pipelines/table.awk "$OUT/comparison.tsv"
cat <<'PAGE'
<p>No laboratory curve at 1.0 MPa is public, only the stress ratio at failure. The laboratory curves are smoothed and not
kinematically consistent (data/SOURCES.md).</p>
<h3>Figures</h3>
PAGE
figure packing 'Before loading, the first packing (thesis Fig. 3.2a): density of contact normals in the x–z plane over the isotropic one (circle at 1), and grains by number of contacts.'
figure response 'Drained triaxial compression (thesis Fig. 3.2b, base of Fig. 2.4): stress ratio and volumetric strain, contraction positive. Points: laboratory, Sun et al. 2007.'
figure fabric 'Fabric anisotropies a<sub>c</sub>, a<sub>n</sub>, a<sub>t</sub> (thesis Eq. 3.9), and q/p from the stress (lines) against q/p from the fabric (points), of the first packing.'
figure state 'Void ratio, and coordination number 2N<sub>c</sub>/N; dashed: without grains of less than two contacts.'
figure energy 'Energy of the first packing at 0.2 MPa. The incremental Hertz–Mindlin law itself takes out or creates energy; what is left over after it is the error of the balance.'
printf '<h3>How it came to be</h3>\n<p>History of the first packing and its run at 0.2 MPa, as the file tells it; the others differ in seed and pressure.</p>\n<pre>'
escaped "$OUT/provenance.txt"
printf '</pre>\n</section>\n'
