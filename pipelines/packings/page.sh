#!/bin/sh
# The packings as a section of the report, on standard output.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: OUT=out/packings page.sh > page.html
set -eu
cat <<'PAGE'
<section id="packings">
<h2>Packings from nothing</h2>
<p>Toyoura sand from its grading curve (<code>pack-generate</code>): a random cloud compressed, friction lowered until the void ratio is
met and restored, from three seeds at each pressure. Grains have the same size however many they are. Those made at 1 kPa are
then loaded in drained triaxial compression at 0.2 MPa. Means over the seeds, ± their standard deviation.</p>
<p>Two packings of one sand at one void ratio do not carry the same: the thesis author's own, of 1000, 2000 and 5000 grains brought to
one size, differ by 5 %, while twins of one packing differ by 1 %.</p>
PAGE
awk -f pipelines/table.awk "$OUT/comparison.tsv"
printf '</section>\n'
