#!/bin/sh
# Chapter 6 as a section of the report, on standard output.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: OUT=out/ch6 PROFILE=quick GRAINS=100 MAIN=4_3 page.sh > page.html
set -eu
export LC_ALL=C.UTF-8
# shellcheck source=pipelines/figure.sh
. "$(dirname "$0")/../figure.sh"
cat <<PAGE
<section id="ch6">
<h2>Two scales: a geosynthetic in soil of aluminium rods</h2>
<p>Explicit finite elements whose points are periodic packings of $GRAINS disks, beside a chain of bars for the geosynthetic
(<code>fem-dem</code>, thesis chapter 6): a sheet that forms a square of soil without confinement, and a sheet that is pulled out
from under soil at 20 kPa. Elements along a side and speed (cm/s) of the runs shown: $MAIN. The thesis publishes curves and
pictures, no numbers: its statements are held against the runs.</p>
PAGE
awk -f pipelines/table.awk "$OUT/comparison.tsv"
cat <<'PAGE'
<p>Known differences from the thesis's program: interface forces are read where the soil is, not one step of the bars further; friction
stays with a place of the sheet while it slides from one bar of the boundary to the next; the time step of the soil follows from its
masses and the contacts; the packings are our own, of the published sizes and numbers of rods. In pull-out the soil is damped by 20 1/s,
not by the thesis's 0.2 1/s: with that it swings on the interface from the first slip to the end of the pull, and as fast as the sheet
is pulled, so that a part of the interface sticks while another slips and the friction is not all mobilised.</p>
<p>Along the inclusion every square of the mesh has a triangle with a side on it and one with a corner on it. In pull-out the former carry about
twice the deviatoric stress of the latter and end contracted, the latter slightly dilated: where point B lies decides its sign, and the
thesis shows it just above the inclusion. Point B is here the point nearest to the middle of the inclusion, one of the former.</p>
<h3>Figures</h3>
PAGE
figures() { # FOLDER
  OUT=$1
  figure global 'Vertical stress at the bottom in shape-forming, mobilised friction in pull-out, over the pull (thesis Fig. 6.2).'
  if [ -e "$OUT/shape_fields.svg" ]; then
    figure shape_fields 'Shape-forming at the end (Fig. 6.3): stress, strain, rotation and anisotropy of the points; arrows: displacement of the nodes from where they began.'
    figure shape_local 'Point A, under the middle of the top, in shape-forming (Fig. 6.5): q/p (blue) and volumetric strain (orange, contraction positive), stress path, fabric anisotropy.'
  fi
  if [ -e "$OUT/pullout_fields.svg" ]; then
    figure pullout_fields 'Pull-out at the end (Fig. 6.4).'
    figure pullout_local 'Point B, above the inclusion, in pull-out (Fig. 6.6).'
  fi
}
figures "$OUT"
kept=pipelines/ch6/kept
if [ "$PROFILE" != thesis ] && [ -e "$kept/comparison.tsv" ]; then
  cat <<'PAGE'
<h3>The same at the thesis's size</h3>
<p>400 rods a point, from the runs whose series lie in pipelines/ch6/kept (how each came to be lies beside it); statements on several
meshes or speeds are of those that are there, as the figure names them.</p>
PAGE
  awk -f pipelines/table.awk "$kept/comparison.tsv"
  figures "$kept"
fi
printf '</section>\n'
