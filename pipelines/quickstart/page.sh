#!/bin/bash
# The quickstart's section of the report, on standard output. Usage: page.sh DIRECTORY EXPECTED
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
directory=$1 expected=$2

figure() {  # NAME CAPTION
  echo '<figure>'
  sed -e '/^<?xml/d' -e '/^<!DOCTYPE/,/>/d' -e "s/gnuplot_plot_/$1_plot_/g" "$directory/$1.svg"
  echo "<figcaption>$2</figcaption></figure>"
}

echo '<section><h2 id="quickstart">Toyoura sand: from a grading curve to triaxial tests</h2>'
echo '<p>1000 spheres follow the Toyoura grading, are brought to a void ratio of 0.68 nearly free of force, compressed isotropically
and sheared in drained triaxial compression with the Hertz–Mindlin parameters of thesis Table 3.1. Each curve is the mean of twins
whose grains start 10<sup>-6</sup> of a radius apart; the band is their standard deviation: a granular assembly is chaotic, and one run
is not a measurement.</p>'

echo '<h3>Measured beside published</h3>'
echo '<table><tr><th>Quantity</th><th>Run</th><th>Published</th><th>Difference</th><th>Tolerance</th><th></th><th>Source</th></tr>'
awk -F '\t' '
  /^#/ || $1 == "quantity" { next }
  NR == FNR { value[$1] = $2; next }
  { met = value[$1] != "" && (value[$1] - $2) ^ 2 <= $3 ^ 2
    printf "<tr><td>%s</td><td class=\"number\">%.4g</td><td class=\"number\">%s</td><td class=\"number\">%+.3g</td><td class=\"number\">±%s</td><td class=\"%s\">%s</td><td>%s</td></tr>\n",
      $4, value[$1], $2, value[$1] - $2, $3, met ? "met" : "missed", met ? "met" : "not met", $5 }' "$directory/metrics.tsv" "$expected"
echo '</table>'
echo '<p>For 1.0 MPa no laboratory curve is public, only the stress ratio at failure.</p>'

figure stress_ratio 'Stress ratio against axial strain (base of thesis Figs. 2.4 and 3.2b). Points: Sun et al. 2007.'
figure volumetric_strain 'Volumetric strain against axial strain, contraction positive (downwards). Points: Sun et al. 2007.'
figure rose 'Contact-orientation diagram before loading (thesis Fig. 3.2a), over the isotropic value.'
figure histogram 'Grains by number of contacts before loading (thesis Fig. 3.2a).'
figure anisotropy 'Fabric anisotropies during shearing at 0.2 MPa, and the stress–force–fabric relation.'
figure coordination 'Coordination number during shearing, rattlers apart.'
figure energy 'Energy balance of one twin at 0.2 MPa. The dashed term is what the incremental Hertz–Mindlin law takes out or creates.'

echo '<h3>How it came to be</h3><pre>'
to-vtk --history "$directory/run_0.2_1.h5" | sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g'
echo '</pre></section>'
