# Figures of chapter 5's analytical part: thesis Figs. 5.2, 5.7, 5.10, 5.12 to 5.20, efficiency, design chart, bands.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: gnuplot -e "out='out/ch5'; format='svg'" figures.gp     (format: svg or png)
set datafile separator "\t"
set datafile commentschars "#"
set encoding utf8
uniaxial(g) = sprintf("%s/uniaxial_%s.tsv", out, g)
triaxial(g, s) = sprintf("%s/triaxial_%s_%skPa.tsv", out, g, s)
line(name) = sprintf("%s/%s.tsv", out, name)
dem(g) = sprintf("data/discrete_element/soilbag_uniaxial_%s.tsv", g)
geotextiles = "PE 0.5PP PP 2PP 3PP 4PP"
analysed = "PE PP 3PP"
pressures = "10 50 100"
blue = "#1f6fb2"; orange = "#d9772b"; green = "#2f8f6b"; grey = "#667080"; red = "#b5394e"; violet = "#7458a6"
colour(g) = g eq "PE" ? blue : g eq "0.5PP" ? grey : g eq "PP" ? orange : g eq "2PP" ? red : g eq "3PP" ? green : violet
percent(name) = 100 * column(name . " [1]")
kilo(name) = column(name) / 1e3

start = 'if (format eq "svg") { set terminal svg size W,H font "Helvetica,14" background "#ffffff" rounded } else { \
  set terminal pngcairo size 2*W,2*H font "Helvetica,14" fontscale 1.9 linewidth 2 pointscale 1.7 background "#ffffff" rounded }'
figure(name) = sprintf("%s/%s.%s", out, name, format)
set border 3 linecolor rgb "#505860" linewidth 1
set xtics nomirror out scale 0.6 textcolor rgb "#303840"
set ytics nomirror out scale 0.6 textcolor rgb "#303840"
set grid linecolor rgb "#e3e6ea" linewidth 0.8 linetype 1
set key noautotitle Left reverse spacing 1.15 samplen 1.6 width -2 textcolor rgb "#303840"
set style fill transparent solid 0.20 noborder

# --- Fig. 5.2: tension of the fabric, yarns 5 mm apart
W = 640; H = 420; @start
set output figure("tension")
set xlabel "tensile strain (%)" offset 0,0.4; set ylabel "tension (kN/m)" offset 0.9,0
set xrange [0:9]; set yrange [0:26]; set key top left
plot for [g in "PE PP"] dem(g) using (column("strain_yarn_face [%]")):(column("tension_yarn_face [N]") / 5) every ::1 with points \
    pointtype 7 pointsize 0.5 linecolor rgb colour(g) title g . ", yarns of the discrete elements", \
  for [g in "PE PP"] uniaxial(g) using (percent("hoop_strain")):(kilo("hoop_tension [N/m]")) with lines linewidth 2.2 \
    linecolor rgb colour(g) title g . ", the model, to half of the strength"

# --- Figs. 5.10, 5.6c, 5.7, 5.12: the lines and their points
W = 900; H = 760; @start
set output figure("lines")
set multiplot layout 2,2 margins 0.105,0.97,0.085,0.985 spacing 0.13,0.12
symbol(k) = int(k) == 0 ? 6 : int(k) == 1 ? 4 : int(k) == 2 ? 8 : 2
set xrange [0:*]; set yrange [0:*]; set key top left
name = "compression_line"
set xlabel "(p/p_a)^{0.3}"; set ylabel "volumetric strain (%)"
plot for [k = 1:3] line(name) using ($1 == k - 1 ? (column("mean_stress [Pa]") / 1e5) ** 0.3 : NaN):(percent("strain_volumetric")) \
    with points pointtype symbol(k - 1) linecolor rgb colour(word(analysed, k)) title word(analysed, k), \
  line(name) using ((column("mean_stress [Pa]") / 1e5) ** 0.3):(percent("fitted")) smooth unique with lines linewidth 1.8 linecolor rgb grey
name = "failure_line"; set logscale x; set xrange [100:10000]; set yrange [1.2:1.8]; set key top right
set xlabel "mean stress (kPa)"; set ylabel "q/p at failure"
plot line(name) using (column("mean_stress [Pa]") / 1e3):(column("failure_obliquity [1]")) with points pointtype 7 linecolor rgb "#303840" \
    title "laboratory", \
  line(name) using (column("mean_stress [Pa]") / 1e3):(column("fitted [1]")) with lines linewidth 1.8 linecolor rgb grey
unset logscale x; set xrange [0:15]; set yrange [0:1.2]
name = "near_failure_line"
set xlabel "deviatoric strain (%)"; set ylabel "M_f − q/p"
plot for [k = 1:3] line(name) using ($1 == k - 1 ? percent("strain_deviatoric") : NaN):(column("distance_to_failure [1]")) \
    with points pointtype symbol(k - 1) linecolor rgb colour(word(analysed, k)) title word(analysed, k), \
  1.386 / (x + 1.27) - 0.035 with lines linewidth 1.8 linecolor rgb "#303840" title "Table 5.2", \
  line(name) using (percent("strain_deviatoric")):(column("fitted [1]")) smooth unique with lines dashtype 2 linewidth 1.8 \
    linecolor rgb grey title "identified"
name = "dilatancy_line"; set xrange [0:0.8]; set yrange [-0.6:1]; set key top left
set xlabel "M_f − q/p"; set ylabel "M_f − M + dε_v^p/dε_d^p"
plot for [k = 1:3] line(name) using ($1 == k - 1 ? column("distance_to_failure [1]") : NaN):(column("distance_of_dilation_rate [1]")) \
    with points pointtype symbol(k - 1) linecolor rgb colour(word(analysed, k)) title word(analysed, k), \
  1.68 * x - 0.344 with lines linewidth 1.8 linecolor rgb "#303840" title "Table 5.2", \
  line(name) using (column("distance_to_failure [1]")):(column("fitted [1]")) smooth unique with lines dashtype 2 linewidth 1.8 \
    linecolor rgb grey title "identified"
unset multiplot

# --- Figs. 5.13 and 5.14: plastic axial strain over p*, Young's modulus over the geotextile's stiffness
W = 900; H = 420; @start
set output figure("stiffness")
set multiplot layout 1,2 margins 0.085,0.97,0.16,0.96 spacing 0.12
set xtics 500; set xrange [0:*]; set yrange [0:10]; set key bottom right
set xlabel "accumulated p* (kPa)"; set ylabel "plastic axial strain (%)"
plot for [k = 1:3] line("accumulated") using ($1 == k - 1 ? column("generalized_stress [kPa]") : NaN):(column("plastic_axial [%]")) \
    with points pointtype symbol(k - 1) linecolor rgb colour(word(analysed, k)) title word(analysed, k), \
  for [k = 1:3] line("accumulated") using ($1 == k - 1 ? column("generalized_stress [kPa]") : NaN):(column("fitted [%]")) \
    with lines linewidth 1.4 linecolor rgb colour(word(analysed, k))
set xtics autofreq; set logscale xy; set xrange [30:1300]; set yrange [1:40]; set key top left
set xlabel "stiffness of the geotextile (kN/m)"; set ylabel "Young's modulus (MPa)"
plot line("stiffness") using (column("tensile_stiffness [N/m]") / 1e3):(column("young_modulus [Pa]") / 1e6) with points pointtype 7 \
    linecolor rgb "#303840" title "from the discrete elements", \
  26.1 * (x / 1e3) ** 0.74 with lines linewidth 1.8 linecolor rgb orange title "Table 5.2"
unset multiplot; unset logscale

# --- Fig. 5.15: surcharge over settlement, six geotextiles
W = 900; H = 600; @start
set output figure("surcharge")
set multiplot layout 2,3 margins 0.105,0.98,0.12,0.985 spacing 0.085,0.12
set xtics 5; set xrange [0:18]; set yrange [0:*]; set key bottom right
do for [g in geotextiles] {
  set label 1 g at graph 0.06,0.92 font ",16" textcolor rgb colour(g)
  set xlabel (strstrt(" 2PP 3PP 4PP ", " " . g . " ") > 0 ? "axial strain (%)" : "")
  set ylabel (g eq "PE" || g eq "2PP" ? "surcharge (kPa)" : "") offset 0.5,0
  if (strstrt(" PE PP 3PP ", " " . g . " ") > 0) {
    plot uniaxial(g) using (percent("strain_axial")):(kilo("surcharge [Pa]")) with lines linewidth 2.2 linecolor rgb colour(g), \
      dem(g) using (column("strain_axial [%]")):(column("surcharge [kPa]")) with points pointtype 6 pointsize 0.6 linecolor rgb "#303840"
  } else {
    plot uniaxial(g) using (percent("strain_axial")):(kilo("surcharge [Pa]")) with lines linewidth 2.2 linecolor rgb colour(g)
  }
}
unset multiplot; unset label 1; set xtics autofreq

# --- Fig. 5.16: internal stresses, hoop strain, volumetric strain
W = 900; H = 760; @start
set output figure("internal")
set multiplot layout 2,2 margins 0.105,0.97,0.085,0.985 spacing 0.13,0.12
set xrange [0:18]; set key top left
set xlabel "axial strain (%)"; set ylabel "axial stress (kPa)"
plot for [g in geotextiles] uniaxial(g) using (percent("strain_axial")):(kilo("axial_stress [Pa]")) with lines linewidth 2 linecolor rgb colour(g) title g, \
  for [g in analysed] dem(g) using (column("strain_axial [%]")):(column("axial_stress [kPa]")) with points pointtype 6 pointsize 0.6 linecolor rgb colour(g)
set ylabel "lateral stress (kPa)"
plot for [g in geotextiles] uniaxial(g) using (percent("strain_axial")):(kilo("radial_stress [Pa]")) with lines linewidth 2 linecolor rgb colour(g), \
  for [g in analysed] dem(g) using (column("strain_axial [%]")):(column("radial_stress [kPa]")) with points pointtype 6 pointsize 0.6 linecolor rgb colour(g)
set xrange [0:9]; set xlabel "hoop strain (%)"; set ylabel "surcharge over stiffness (1/m)"
hoop(horizontal, face, vertical) = (horizontal + (5 * face + vertical) / 6) / 2
plot for [g in geotextiles] uniaxial(g) using (percent("hoop_strain")):(column("reinforcing_efficiency [1/m]")) with lines linewidth 2 linecolor rgb colour(g), \
  for [g in analysed] dem(g) using (hoop(column("strain_yarn_horizontal [%]"), column("strain_yarn_face [%]"), column("strain_yarn_vertical [%]"))): \
    (column("surcharge [kPa]") / column("tensile_stiffness [kN/m]")) with points pointtype 6 pointsize 0.6 linecolor rgb colour(g)
set xrange [0:18]; set yrange [-4:3]; set xlabel "deviatoric strain (%)"; set ylabel "volumetric strain (%)"
plot for [g in geotextiles] uniaxial(g) using (percent("strain_deviatoric")):(percent("strain_volumetric")) with lines linewidth 2 linecolor rgb colour(g), \
  for [g in analysed] dem(g) using (column("strain_axial [%]") - column("strain_volumetric [%]") / 3):(column("strain_volumetric [%]")) \
    with points pointtype 6 pointsize 0.6 linecolor rgb colour(g)
unset multiplot

# --- Figs. 5.17 to 5.20: triaxial compression
do for [k = 1:4] {
  name = word("triaxial_surcharge triaxial_axial triaxial_lateral triaxial_volumetric", k)
  abscissa = k == 4 ? "strain_deviatoric" : "strain_axial"
  ordinate = word("surcharge axial_stress radial_stress strain_volumetric", k)
  W = 900; H = 360; @start
  set output figure(name)
  set multiplot layout 1,3 margins 0.115,0.975,0.18,0.96 spacing 0.085
  set xtics 5
  set xrange [0:*]; if (k < 4) { set yrange [0:*] } else { set yrange [*:*] }
  if (k < 4) { set key top left } else { set key bottom left }
  set xlabel (k == 4 ? "deviatoric strain (%)" : "axial strain (%)")
  do for [g in "PE PP 5PP"] {
    set label 1 g at graph 0.85,(k == 4 ? 0.92 : 0.08) right font ",16" textcolor rgb colour(g eq "5PP" ? "4PP" : g)
    set ylabel (g ne "PE" ? "" : k == 1 ? "surcharge (kPa)" : k == 2 ? "axial stress (kPa)" : k == 3 ? "lateral stress (kPa)" : "volumetric strain (%)")
    plot for [j = 1:3] triaxial(g, word(pressures, j)) using (percent(abscissa)): \
      (k == 4 ? percent(ordinate) : kilo(ordinate . " [Pa]")) with lines linewidth 2 dashtype j \
      linecolor rgb colour(g eq "5PP" ? "4PP" : g) title word(pressures, j) . " kPa"
  }
  unset multiplot; unset label 1
}
set xtics autofreq

# --- Efficiency and design chart: geotextiles of PP's kind
W = 900; H = 420; @start
set output figure("chart")
set multiplot layout 1,2 margins 0.125,0.92,0.16,0.96 spacing 0.13
set logscale x; set xrange [30:1160]; set yrange [0:*]; set key bottom right
set xlabel "stiffness of the geotextile (kN/m)"; set ylabel "surcharge (kPa)"; set logscale y; set yrange [100:10000]
plot line("chart") using (kilo("stiffness [N/m]")):(kilo("capacity [Pa]")) with lines linewidth 2.2 linecolor rgb "#303840" title "ultimate", \
  "" using (kilo("stiffness [N/m]")):(kilo("allowable_surcharge [Pa]")) with lines linewidth 2.2 linecolor rgb orange \
    title "within 6 %, safety 1.5"
unset logscale y; set yrange [0:28]; set y2range [0:12]; set y2tics out scale 0.6; set ytics nomirror; set key top right
set ylabel "settlement (%)"; set y2label "efficiency (1/m)"
plot line("chart") using (kilo("stiffness [N/m]")):(percent("settlement")) with lines linewidth 2.2 linecolor rgb "#303840" title "at the ultimate load", \
  "" using (kilo("stiffness [N/m]")):(percent("service_settlement")) with lines linewidth 2.2 linecolor rgb orange title "at 300 kPa", \
  "" using (kilo("stiffness [N/m]")):(column("reinforcing_efficiency [1/m]")) axes x1y2 with lines linewidth 2.2 dashtype 2 \
    linecolor rgb green title "efficiency (right)"
unset multiplot; unset logscale; unset y2tics; unset y2label

# --- Bands of the identified constants
W = 900; H = 420; @start
set output figure("bands")
set multiplot layout 1,2 margins 0.115,0.97,0.16,0.96 spacing 0.12
set xrange [0:14]; set yrange [0:*]; set key top left; set xlabel "axial strain (%)"; set ylabel "surcharge (kPa)"
plot line("bands") using (percent("settlement")):(kilo("surcharge_low [Pa]")):(kilo("surcharge_high [Pa]")) with filledcurves fillcolor rgb orange \
    title "95 % of the draws", \
  "" using (percent("settlement")):(kilo("surcharge [Pa]")) with lines linewidth 2 linecolor rgb orange title "their median", \
  uniaxial("PP") using (percent("strain_axial")):(kilo("surcharge [Pa]")) with lines dashtype 2 linewidth 2 linecolor rgb "#303840" title "Table 5.2", \
  dem("PP") using (column("strain_axial [%]")):(column("surcharge [kPa]")) with points pointtype 6 pointsize 0.6 linecolor rgb "#303840" title "discrete elements"
set ylabel "lateral stress (kPa)"
plot line("bands") using (percent("settlement")):(kilo("radial_stress_low [Pa]")):(kilo("radial_stress_high [Pa]")) with filledcurves fillcolor rgb orange, \
  "" using (percent("settlement")):(kilo("radial_stress [Pa]")) with lines linewidth 2 linecolor rgb orange, \
  uniaxial("PP") using (percent("strain_axial")):(kilo("radial_stress [Pa]")) with lines dashtype 2 linewidth 2 linecolor rgb "#303840", \
  dem("PP") using (column("strain_axial [%]")):(column("radial_stress [kPa]")) with points pointtype 6 pointsize 0.6 linecolor rgb "#303840"
unset multiplot
set output
