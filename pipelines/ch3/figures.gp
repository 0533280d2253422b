# Figures of chapter 3 that are drawn of tables the full size keeps, too: compression, paths, yarns, shear, growth, contacts. After style.gp.
# SPDX-License-Identifier: GPL-3.0-or-later
uc(g) = sprintf("%s/uc_%s.tsv", out, g)
# Runs that are there: of full size, what is kept may be a part.
bags = system(sprintf("for g in PE PP; do test ! -e %s/uc_$g.tsv || echo $g; done", out))
recorded(g) = sprintf("data/discrete_element/soilbag_uniaxial_%s.tsv", g)
# Of the full size, kept. Where this is it, one run is drawn over itself: a loop over no words would still go round once.
full = yarns == 1 ? '' : system("cd pipelines/ch3/kept && ls | sed -n 's/^uc_\\([A-Z]*\\)\\.tsv$/\\1/p'")
kept(g) = g eq '' ? uc('PE') : sprintf("pipelines/ch3/kept/uc_%s.tsv", g)
named(g, unit) = g eq '' ? '' : g.unit.' full size'
# From the end of the preload, which is the first stage.
start = 0
way(n) = C("displacement_bottom_z [m]") - C("displacement_top_z [m]")
strain(n) = C("stage [1]") == 0 ? (start = way(0), 0) : 100 * (way(0) - start) / 0.08
if (words(bags) > 0) {
set output sprintf("%s/compression.%s", out, format)
set multiplot layout 1,2
set xlabel 'axial strain (%)'; set xrange [0:20]
set ylabel 'load over 0.16 m² (kPa)'
plot for [g in bags] uc(g) using (strain(0)):(abs(C("force_top_z [N]")) / 160) with linespoints lc hue(g) pt 7 ps 0.4 title g, \
  for [k = 1:words(full)] kept(word(full, k)) using (strain(0)):(abs(C("force_top_z [N]")) / 160) with lines lc hue(word(full, k)) dt 2 title named(word(full, k), ''), \
  for [g in "PE PP"] recorded(g) using "strain_axial [%]":"plate_pressure [kPa]" with points lc hue(g) pt 6 title g.' recorded'
set ylabel 'axial stress in the soil (kPa)'
plot for [g in bags] uc(g) using (strain(0)):(C("soil_stress_zz [Pa]") / 1000) with linespoints lc hue(g) pt 7 ps 0.4 title g, \
  for [k = 1:words(full)] kept(word(full, k)) using (strain(0)):(C("soil_stress_zz [Pa]") / 1000) with lines lc hue(word(full, k)) dt 2 title named(word(full, k), ''), \
  for [g in "PE PP"] recorded(g) using "strain_axial [%]":"axial_stress [kPa]" with points lc hue(g) pt 6 title g.' recorded'
unset multiplot
set output sprintf("%s/paths.%s", out, format)
set multiplot layout 1,2
set xlabel 'p (kPa)'; set xrange [0:*]; set xtics 200
set ylabel 'q (kPa)'
plot for [g in bags] uc(g) using (C("soil_mean_stress [Pa]") / 1000):(C("soil_deviatoric_stress [Pa]") / 1000) with linespoints lc hue(g) pt 7 ps 0.4 title g, \
  for [k = 1:words(full)] kept(word(full, k)) using (C("soil_mean_stress [Pa]") / 1000):(C("soil_deviatoric_stress [Pa]") / 1000) with lines lc hue(word(full, k)) dt 2 title named(word(full, k), ''), \
  for [g in "PE PP"] recorded(g) using "mean_stress [kPa]":"deviatoric_stress [kPa]" with points lc hue(g) pt 6 title g.' recorded'
set xlabel 'axial strain (%)'; set xrange [0:20]; set xtics autofreq
set ylabel 'void ratio'
plot for [g in bags] uc(g) using (strain(0)):"soil_delaunay_void_ratio [1]" with linespoints lc hue(g) pt 7 ps 0.4 title g, \
  for [k = 1:words(full)] kept(word(full, k)) using (strain(0)):"soil_delaunay_void_ratio [1]" with lines lc hue(word(full, k)) dt 2 title named(word(full, k), ''), \
  for [g in "PE PP"] recorded(g) using "strain_axial [%]":"void_ratio [1]" with points lc hue(g) pt 6 title g.' recorded'
unset multiplot
set output sprintf("%s/yarns.%s", out, format)
set multiplot layout 1,2
set ylabel 'tension of yarns on the faces (N)'
plot for [g in bags] uc(g) using (strain(0)):(C("yarn_tension_face [N]") / yarns) with linespoints lc hue(g) pt 7 ps 0.4 title g, \
  for [k = 1:words(full)] kept(word(full, k)) using (strain(0)):(C("yarn_tension_face [N]")) with lines lc hue(word(full, k)) dt 2 title named(word(full, k), ''), \
  for [g in "PE PP"] recorded(g) using "strain_axial [%]":"tension_yarn_face [N]" with points lc hue(g) pt 6 title g.' recorded'
set ylabel 'broken yarns'
plot for [g in bags] uc(g) using (strain(0)):"broken_yarns [1]" with linespoints lc hue(g) pt 7 ps 0.4 title g, \
  for [k = 1:words(full)] kept(word(full, k)) using (strain(0)):"broken_yarns [1]" with lines lc hue(word(full, k)) dt 2 title named(word(full, k), '')
unset multiplot
set autoscale
}
if (words(loads) > 0) {
set output sprintf("%s/shear.%s", out, format)
set xlabel 'shear displacement over height (%)'
set ylabel 'shear over normal force'
tint(p) = sum [n = 1:6] (word("1330 1870 2410 12050 24100 36150", n) eq p ? n : 0)
full_loads = yarns == 1 ? '' : system("cd pipelines/ch3/kept && ls | sed -n 's/^ss_\\([0-9]*\\)\\.tsv$/\\1/p' | sort -n")
kept_shear(p) = p eq '' ? sprintf("%s/ss_%s.tsv", out, word(loads, 1)) : sprintf("pipelines/ch3/kept/ss_%s.tsv", p)
way_of_shear(n) = 100 * C("displacement_top_x [m]") / 0.08
shear_ratio(n) = abs(C("force_top_x [N]") / C("force_top_z [N]"))
set key outside right top
plot for [p in loads] sprintf("%s/ss_%s.tsv", out, p) using (way_of_shear(0)):(shear_ratio(0)) with linespoints lc tint(p) pt 7 ps 0.4 title p.' N', \
  for [k = 1:words(full_loads)] kept_shear(word(full_loads, k)) using (way_of_shear(0)):(shear_ratio(0)) with lines lc tint(word(full_loads.' '.loads, k)) dt 2 title named(word(full_loads, k), ' N')
set key inside left top
}
# Growth of the grains, beside that of the full size, which is kept.
set output sprintf("%s/growth.%s", out, format)
set multiplot layout 1,2
set xlabel 'radii grown by (%)'
grown(n) = 100 * (C("growth [1]") - 1)
set ylabel 'void ratio'
set key right top
plot out."/generation.tsv" using (grown(0)):"delaunay_void_ratio [1]" with linespoints pt 7 ps 0.4 title 'this bag', \
  "pipelines/ch3/kept/generation.tsv" using (grown(0)):"delaunay_void_ratio [1]" with linespoints pt 7 ps 0.4 title 'full size'
set ylabel 'coordination number'
set key left top
plot out."/generation.tsv" using (grown(0)):"coordination_number [1]" with linespoints pt 7 ps 0.4 title 'this bag', \
  "pipelines/ch3/kept/generation.tsv" using (grown(0)):"coordination_number [1]" with linespoints pt 7 ps 0.4 title 'full size'
unset multiplot
# Contacts of the bag beside those of the representative volume.
contacts = "rv bag bag_soil"
name(of) = of eq 'rv' ? 'representative volume' : of eq 'bag' ? 'bag' : 'bag, soil with soil'
set output sprintf("%s/shape.%s", out, format)
set multiplot layout 1,2
set style fill solid 0.65 noborder
set key right top
set xlabel 'contacts of a grain'
set ylabel 'grains (%)'
set xrange [-0.6:10.6]; set yrange [0:35]
array grains[3]
do for [k = 1:3] {
  stats sprintf("%s/%s_histogram.tsv", out, word(contacts, k)) using "grains [1]" nooutput
  grains[k] = STATS_sum
}
plot for [k = 1:3] sprintf("%s/%s_histogram.tsv", out, word(contacts, k)) \
  using (C("contacts [1]") + 0.27 * (k - 2)):(100 * C("grains [1]") / grains[k]):(0.25) with boxes lc k title name(word(contacts, k))
set xlabel 'angle from the vertical (deg)'
set ylabel 'contacts over those of an isotropic packing'
set xrange [0:90]; set yrange [0:*]
set key right bottom
plot for [k = 1:3] sprintf("%s/%s_rose.tsv", out, word(contacts, k)) \
  using (C("plane [1]") == 0 ? C("angle [deg]") : NaN):"density [1]" with linespoints lc k pt 7 ps 0.4 title name(word(contacts, k))
unset multiplot
set autoscale
