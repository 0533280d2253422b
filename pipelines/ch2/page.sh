#!/bin/bash
# Chapter 2 as a section of the report, on standard output.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: OUT=out/ch2 CASES='hm_1000_0.2 ...' SAMPLES='32 24' LAST=2 ERROR=0.1,0.025,0.1 PROFILE=quick page.sh > page.html
set -euo pipefail
export LC_ALL=C.UTF-8

# Inline SVG: identifiers get the figure's name, since gnuplot gives every figure the same ones.
figure() { # NAME CAPTION
  [[ -s $OUT/$1.svg ]] || return 0
  printf '<figure>\n'
  sed -e '/^<?xml/d' -e '/^<!DOCTYPE/,/>/d' -e "s/id='\([^']*\)'/id='$1_\1'/g" -e "s/id=\"\([^\"]*\)\"/id=\"$1_\1\"/g" \
    -e "s/href='#\([^']*\)'/href='#$1_\1'/g" -e "s/url(#\([^)]*\))/url(#$1_\1)/g" "$OUT/$1.svg"
  printf '<figcaption>%s</figcaption>\n</figure>\n' "$2"
}
escaped() { sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g' -e 's/>/\&gt;/g' "$1"; }

cat <<PAGE
<section id="ch2">
<h2>Contact parameters of Toyoura sand, identified with the particle filter</h2>
<p>Parameter sets are drawn from a prior (<code>pf-weight draw</code>), each is run through the drained triaxial test, one row one job
under GNU parallel, and the laboratory's curve weighs them step by step (<code>pf-weight assimilate</code>, thesis Eqs. 2.3–2.8) with the
variances ${ERROR//,/, } of the observation error on radial strain (%), stress ratio and volumetric strain (%): the thesis's 0.1 for all
lets the strains decide alone, and sets are chosen that miss the stress ratio. Rounds of ${SAMPLES// / and }
sets; each round after the first is drawn around the posterior of all sets before it, and the sets of all rounds count as one sample,
each with the importance that corrects for where it was drawn (<code>pf-weight resample --keep</code>): the thesis has one round. Profile: ${PROFILE}.</p>
PAGE
if [[ $PROFILE == quick ]]; then
  echo '<p>The quick profile has a narrower prior than the thesis, a few tens of sets and a shorter test: it shows how the method works,
not the thesis'"'"'s numbers. Curves of the laboratory are public at 0.2 and 0.5 MPa only; at other pressures the thesis profile observes
the greatest stress ratio alone.</p>'
else
  echo '<p>Curves of the laboratory are public at 0.2 and 0.5 MPa only; at other pressures the greatest stress ratio alone is
observed, which does not determine five parameters: their means stay near those of the prior, except the friction angle.</p>'
fi
echo '<h3>Measured beside published</h3>'
awk -f pipelines/table.awk "$OUT/comparison.tsv"
cat <<'PAGE'
<p>Misfits count up to the strain that the runs are compared at; over the whole curve a set identified on a part of it is extrapolated.
The rolling parameters and the friction angle trade against one another: sets far apart fit as well.</p>
PAGE
echo '<h3>Statements of §2.4</h3>'
awk -f pipelines/table.awk "$OUT/checklist.tsv"
if [[ $PROFILE == quick ]]; then
  echo '<p>That the means settle is not to be seen with so few sets: the thesis'"'"'s error is small beside their distances, all weight is on one
set at a time, and it moves to another where the curves cross. The second round is drawn closer, and the means of both together are the ones used.</p>'
fi
echo '<h3>Figures</h3>'
figure means_cl 'Weighted means over axial strain, linear contacts (thesis Fig. 2.1).'
figure means_hm 'Weighted means over axial strain, Hertz–Mindlin contacts (thesis Fig. 2.2).'
figure pressure_hm 'Identified means over confining pressure, Hertz–Mindlin (thesis Fig. 2.3).'
figure pressure_cl 'The same, linear contacts.'
figure prediction 'The test run with the identified parameters and with the sets that the thesis identified, beside the laboratory (thesis Fig. 2.4).'
for case in $CASES; do figure "density_$case" "Marginal posterior densities at several strains, case ${case//_/ }; per decade for E."; done
figure size 'Effective sample size over axial strain.'
for case in $CASES; do
  printf '<h3>Case %s</h3>\n<pre>' "${case//_/ }"
  escaped "$OUT/$case/posterior$LAST.txt"
  printf '</pre>\n'
done
printf '</section>\n'
