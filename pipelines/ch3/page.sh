#!/bin/sh
# Chapter 3 as a section of the report, on standard output.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: OUT=out/ch3 PROFILE=quick page.sh > page.html
set -eu
# shellcheck source=pipelines/figure.sh
. "$(dirname "$0")/../figure.sh"

cat <<'PAGE'
<section id="ch3">
<h2>The soilbag</h2>
<p>Copies of a representative volume of Toyoura sand, cut to the pillow of a filled bag, wrapped in a woven geotextile of nodes and
yarns and grown until they press (<code>filter-expand</code>); compressed between smooth plates and sheared by rough ones under a dead
load (<code>run-dem</code>). Plates move slower than the thesis's 10 %/s, which throws grains of a thousandfold density, and all is damped
while a station waits for rest.</p>
PAGE
[ "$PROFILE" = thesis ] || cat <<'PAGE'
<p>Quick profile: grains and yarns are twice as large as the thesis's. Along the walls they leave twice the room, so that the bag is made
to a void ratio of 0.73: its middle is then as dense as that of the full bag at 0.675 (0.66). It dilates less, and its load lags behind
the recorded one at equal strain by a fifth; at equal tension of the yarns the two are to be compared. Denser (0.67, the number of the
thesis) it would carry a q/p 8 % above the recorded one.</p>
PAGE
echo '<h3>Measured beside published</h3>'
awk -f pipelines/table.awk "$OUT/comparison.tsv"
echo '<h3>Statements</h3>'
awk -f pipelines/table.awk "$OUT/checklist.tsv"
cat <<'PAGE'
<h3>What moves the numbers</h3>
<p>One at a time, on bags of the quick profile, the rest as it is here:</p>
<table>
<tr><th>cause</th><th>from, to</th><th>effect</th></tr>
<tr><td>void ratio of the bag</td><td>0.669, 0.715, 0.723</td><td>q/p at the first break over the recorded one 1.08, 1.00, 0.99 (PE) and 1.09 to 1.00
(PP); early loss of void ratio 0.0011, 0.0055, 0.0058 (PE); axial stress at equal strain +24, −21, −27 % (PE)</td></tr>
<tr><td>contacts with the geotextile in the stress</td><td>with, without</td><td>q/p −0.11; −0.06 at full size</td></tr>
<tr><td>damping at rest</td><td>0.2, 0.9</td><td>q/p +2 to +3 %</td></tr>
<tr><td>speed of the plates</td><td>2, 4, 10 %/s</td><td>q/p less than 1 %, less than 4 % (between 8 and 10 %)</td></tr>
</table>
<p>The recorded load over the recorded stress needs a volume of 0.0150 m³ (80.3 mm of 80 mm height, here 80.3): that of the soil up to its
geotextile. The tetrahedra between the grains' centres fill 0.0144 m³ of the full bag, so that void ratios are those of the power
cells.</p>
PAGE
echo '<h3>Figures</h3>'
picture bag 'The bag of PE before it is compressed, near its greatest load and ruptured: deviatoric strain of the grains cut by the plane in
its middle (Fig. 3.14), tension of the yarns on its upper face (Fig. 3.17).'
figure growth 'Growth of the grains in the bag, this one and the one of full size (kept, pipelines/ch3/kept): friction is lowered and the
grains relieved until the void ratio and the coordination number are met.'
figure compression 'Uniaxial compression (thesis Figs. 3.6 and 3.7). Points: recorded series of the same model.'
figure paths 'Stress paths and void ratio (Figs. 3.10 and 3.12).'
figure yarns 'Tension of the yarns on the faces, and broken yarns.'
figure shear 'Simple shear under dead loads (Fig. 3.8).'
figure strip 'Wide-width tension with unloading and reloading (Fig. 3.3).'
figure box 'Shear box on a fixed sheet under 50 kPa, friction of 21 and 25 degrees between nodes and soil (Fig. 3.5): grains catch between
nodes, so that the interface carries more than either.'
echo '</section>'
