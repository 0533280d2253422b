# Pictures of chapter 3: breaks, strip, shear box, the bag. After style.gp.
# SPDX-License-Identifier: GPL-3.0-or-later
set output sprintf("%s/breaks.%s", out, format)
set multiplot layout 1,2
set xlabel 'x (mm)'
set ylabel 'y (mm)'
set xrange [-260:260]; set yrange [-260:260]; set size ratio -1
do for [run in "uc_PE uc_PE_rough"] {
  set title run eq 'uc_PE' ? 'smooth plates' : 'rough plates'
  plot sprintf("%s/%s_breaks.tsv", out, run) using "x [mm]":"y [mm]" with points lc hue('PE') pt 7 ps 0.3
}
unset multiplot
unset title
set autoscale; set size noratio
set key left top
set output sprintf("%s/strip.%s", out, format)
set xlabel 'strain (%)'
set ylabel 'tension of a yarn (N)'
plot for [g in "PE PP"] sprintf("%s/strip_%s.tsv", out, g) using (C("displacement_right_y [m]") * 1000):(abs(C("force_right_y [N]")) / 5) with linespoints lc hue(g) pt 7 ps 0.4 title g
set output sprintf("%s/box.%s", out, format)
set xlabel 'displacement (mm)'
set ylabel 'shear over normal force'
set key right bottom
plot for [a in "21 25"] sprintf("%s/box_%s.tsv", out, a) using (1000 * C("displacement_left_x [m]")): \
  (abs((C("force_left_x [N]") + C("force_right_x [N]")) / C("force_lid_z [N]"))) with linespoints pt 7 ps 0.4 title a.(a eq '21' ? '° (PP)' : '° (PE)')
set key left top
# The bag before it is compressed, near its greatest load, and ruptured: cut in the middle, and from above. Too many marks for SVG.
if (format eq 'png') {
set output sprintf("%s/bag.png", out)
set terminal pngcairo size 1000,850 font 'sans,11'
set multiplot
set key off; set size ratio -1; set autoscale; set style fill solid noborder; unset xlabel; unset ylabel
set xrange [-280:280]
set palette defined (0 "#440154", 0.25 "#3b528b", 0.5 "#21918c", 0.75 "#5ec962", 1 "#fde725")
strains = "0 12 ".end
do for [k = 1:3] {
  middle = 1 - (k - 0.5) / 3
  set lmargin at screen 0.05; set rmargin at screen 0.49; set bmargin at screen middle - 0.06; set tmargin at screen middle + 0.06
  set yrange [-65:65]; set xtics 100; set ytics 50
  set cbrange [0:0.4]; set cbtics 0.1; set title sprintf("%s %%: deviatoric strain", word(strains, k))
  plot sprintf("%s/section_%d.tsv", out, k) using 1:2:3:4 with circles lc palette, \
    "" using (valid(4) ? NaN : column(1)):2:3 with circles lc rgb "#808080"
  set lmargin at screen 0.66; set rmargin at screen 0.864; set bmargin at screen middle - 0.125; set tmargin at screen middle + 0.115
  set yrange [-280:280]; set xtics 200; set ytics 100
  set cbrange [0:*]; set cbtics autofreq; set title sprintf("%s %%: tension of the upper yarns (N), red: broken", word(strains, k))
  plot sprintf("%s/face_%d.tsv", out, k) using 1:2:(column(6) == 1 ? NaN : column(3)):4:5 with vectors nohead lc palette, \
    "" using (column(6) == 1 ? column(1) + 0.5 * column(3) : NaN):(column(2) + 0.5 * column(4)) with points pt 7 ps 0.4 lc rgb "#e31a1c"
}
unset multiplot
}
