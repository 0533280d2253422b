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
load (<code>run-dem</code>). Plates move at 2 %/s, not the thesis's 10 %/s: a bag of thousandfold density widens too slowly to follow
those, and its soil, held by its own inertia, contracts more. Speed times the root of density counts, so that these are its 10 %/s at
fortyfold density. A drag stills all while a station waits for rest.</p>
PAGE
[ "$PROFILE" = thesis ] || cat <<'PAGE'
<p>Quick profile: grains and yarns are twice as large as the thesis's. Along the walls they leave twice the room, so that the bag is made
to a void ratio of 0.73 (pipelines/ch3/study.mk): its middle is then about as dense as that of the full bag at 0.675. It dilates less,
and its load lags behind the recorded one at equal strain; at equal tension of the yarns the two are to be compared. As dense as the
thesis's bag on the whole, it is too dense in the middle, and its stress path too steep.</p>
PAGE
echo '<h3>Measured beside published</h3>'
awk -f pipelines/table.awk "$OUT/comparison.tsv"
echo '<h3>Statements</h3>'
awk -f pipelines/table.awk "$OUT/checklist.tsv"
cat <<'PAGE'
<p>Of the tests (three bags of PE under compression, one of PP under shear, shear box) figures alone are published, no numbers; that the
simulated bag is softer at first, that it strains more under shear and that the tested bag of PE did not fail is therefore not
measured here. Of friction at the faces before failure the thesis says in §3.3.4 that it develops on the upper and lower one only, and
in §3.4 that it is higher on the sides: one of the two is not met.</p>
<h3>Contacts of the bag beside those of the representative volume</h3>
<p>The thesis finds the same shapes in its diagrams. Here the greatest difference of cumulative shares (Kolmogorov and Smirnov's distance)
is set beside the one that two samples of these sizes, drawn from the same soil, exceed with a chance of 5 %; for classes, as these
are, the chance is smaller still. Samples are grains for the number of contacts, contacts for their angle. The representative volume,
made at 1 kPa, is unloaded to 0.16 kPa, where it has about as many contacts a grain as the bag is made to. Contacts count as in the
thesis, with soil and with the geotextile; of soil with soil alone the bag has fewer, and fewer along the vertical, since its upper and
lower faces are near.</p>
PAGE
awk -f pipelines/table.awk "$OUT/shape.tsv"
kept=pipelines/ch3/kept
if ls "$kept"/variants_*.tsv > /dev/null 2>&1; then
  cat <<'PAGE'
<h3>What differences come from</h3>
<p>The bag of PE varied in one thing at a time (<code>make ch3-variants</code>; kept, pipelines/ch3/kept): load and stress path under
uniaxial compression beside those of the bag itself. Other representative volumes tell how much of a difference is chance.</p>
<p>The recorded bag is softer at first than ours of full size, its stress ratio rises over the first few per cent, and it contracts
before it dilates; ours has its full ratio from the first station on. Part of it is what rest is worth: left to swing without drag at
each station (<code>undragged</code>), grains of a thousandfold density fall short of it at the toe as the recorded ones do. At full
size such a bag follows the record at equal tension of its yarns, and lags behind it in strain. Another part is how the bag is filled
and meshed (<code>unstretched</code>, <code>meshed_by_face</code>, <code>flat_faces</code> of pipelines/ch3/variants.tsv). At 10 %/s
(<code>swinging</code>), the rate of the thesis, they are thrown. Slower plates (<code>slow</code>, <code>slower</code>) change nothing more: ours is the bag at rest. The bend of the yarn's
curve, which is an estimate, and the density of the packing are worth as much over the whole range.</p>
PAGE
  for size in quick thesis; do
    [ -e "$kept/variants_$size.tsv" ] || continue
    echo "<p>PROFILE=$size:</p>"
    awk -f pipelines/table.awk "$kept/variants_$size.tsv"
  done
fi
if [ "$PROFILE" != thesis ] && [ -e "$kept/comparison.tsv" ]; then
  cat <<'PAGE'
<h3>The same at full size</h3>
<p>Kept from the run whose series lie beside it (pipelines/ch3/kept; <code>make reproduce PROFILE=thesis</code> makes them anew).</p>
PAGE
  awk -f pipelines/table.awk "$kept/comparison.tsv"
  awk -f pipelines/table.awk "$kept/checklist.tsv"
  awk -f pipelines/table.awk "$kept/shape.tsv"
fi
echo '<h3>Figures</h3>'
picture bag 'The bag of PE before it is compressed, near its greatest load and ruptured: deviatoric strain of the grains cut by the plane in
its middle (Fig. 3.14), tension of the yarns on its upper face (Fig. 3.17).'
figure shape 'Grains by their number of contacts, and contacts by their angle from the vertical (1: as many as if all directions were
alike): the bag as it is made and the representative volume (Figs. 3.2 and 3.4).'
figure growth 'Growth of the grains in the bag, this one and the one of full size (kept, pipelines/ch3/kept): friction is lowered and the
grains relieved until the void ratio and the coordination number are met.'
figure compression 'Uniaxial compression (thesis Figs. 3.6 and 3.7). Points: recorded series of the same model. Dashed: our
full size (kept, pipelines/ch3/kept); dotted: the same, left to swing at each station.'
figure paths 'Stress paths and void ratio (Figs. 3.10 and 3.12).'
figure yarns 'Tension of the yarns on the faces, and broken yarns.'
figure breaks 'Where yarns are broken at the end, seen from above: between smooth plates in the middle, between rough ones along the
seams (Fig. 3.6). PE.'
figure shear 'Simple shear under dead loads (Fig. 3.8). Dashed: our full size.'
figure strip 'Wide-width tension with unloading and reloading (Fig. 3.3).'
figure box 'Shear box on a fixed sheet under 50 kPa, friction of 21 and 25 degrees between nodes and soil (Fig. 3.5): grains catch between
nodes, so that the interface carries more than either.'
echo '</section>'
