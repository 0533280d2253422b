# Figures of the quickstart study: thesis Fig. 3.2, the base of Fig. 2.4, fabric, state and energy.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: gnuplot -e "out='out/quickstart'; format='svg'" figures.gp     (format: svg or png)
set datafile separator "\t"
set datafile commentschars "#"
set encoding utf8
lab(p) = sprintf("data/laboratory/toyoura_drained_triaxial_%sMPa.tsv", p)
ensemble(p) = sprintf("%s/ensemble_%sMPa.tsv", out, p)
run(p, table) = sprintf("%s/runs/%sMPa_1/%s.tsv", out, p, table)
pressures = "0.2 0.5 1.0"
blue = "#1f6fb2"; orange = "#d9772b"; green = "#2f8f6b"; grey = "#667080"; red = "#b5394e"; violet = "#7458a6"
colour(k) = word(blue . " " . orange . " " . green, k)

# Starts a figure; sizes in svg units, twice as many dots in png.
start = 'if (format eq "svg") { set terminal svg size W,H font "Helvetica,14" background "#ffffff" rounded } else { \
  set terminal pngcairo size 2*W,2*H font "Helvetica,14" fontscale 1.9 linewidth 2 pointscale 1.7 background "#ffffff" rounded }'
set border 3 linecolor rgb "#505860" linewidth 1
set xtics nomirror out scale 0.6 textcolor rgb "#303840"
set ytics nomirror out scale 0.6 textcolor rgb "#303840"
set grid linecolor rgb "#e3e6ea" linewidth 0.8 linetype 1
set key noautotitle Left reverse spacing 1.15 samplen 1.6 width -2 textcolor rgb "#303840"
set style fill transparent solid 0.20 noborder

stats sprintf("%s/histogram.tsv", out) using (column("grains [1]")) nooutput
grains = STATS_sum

# --- Fig. 3.2a: contact orientation and coordination before loading
W = 900; H = 420; @start
set output sprintf("%s/packing.%s", out, format)
set multiplot layout 1,2 margins 0.03,0.985,0.15,0.90 spacing 0.12
set title "Contact orientation, x–z plane"
unset border; unset tics; unset grid; set size ratio -1
limit = 1.6
set xrange [-limit:limit]; set yrange [-limit:limit]
set arrow 1 from -limit,0 to limit,0 nohead linecolor rgb "#d5d9de"
set arrow 2 from 0,-limit to 0,limit nohead linecolor rgb "#d5d9de"
set label 1 "x" at limit,0.1 right textcolor rgb grey
set label 2 "z" at 0.07,limit-0.03 textcolor rgb grey
do for [k = 1:3] { set label 10 + k sprintf("%.1f", 0.5 * k) at 0.52 * k * cos(pi / 4),0.52 * k * sin(pi / 4) font ",11" textcolor rgb grey }
set samples 200; set parametric; set trange [0:2 * pi]
plot sprintf("%s/petals.tsv", out) using 1:2 skip 1 with filledcurves closed fillcolor rgb blue fillstyle transparent solid 0.6 \
    border linecolor rgb "#ffffff", \
  for [k = 1:3] 0.5 * k * cos(t), 0.5 * k * sin(t) with lines linewidth (k == 2 ? 1.8 : 0.8) \
    linecolor rgb (k == 2 ? orange : "#d5d9de")
unset parametric; unset arrow; unset label; set border 3; set xtics nomirror out scale 0.6; set ytics nomirror out scale 0.6; set size noratio
set grid noxtics ytics linecolor rgb "#e3e6ea" linetype 1
set title "Coordination number"
set xlabel "contacts of a grain" offset 0,0.4; set ylabel "share of grains (%)" offset 0.9,0
set xtics 1; set xrange [-0.7:*]; set yrange [0:*]; set boxwidth 0.8
plot sprintf("%s/histogram.tsv", out) using (column("contacts [1]")):(100 * column("grains [1]") / grains) with boxes fillcolor rgb blue fillstyle solid 0.65 notitle
unset multiplot
set autoscale; unset title; set xtics auto; set grid xtics ytics

# --- Fig. 3.2b, base of Fig. 2.4: drained triaxial response with laboratory points
W = 900; H = 460; @start
set output sprintf("%s/response.%s", out, format)
set multiplot layout 1,2 margins 0.095,0.985,0.15,0.96 spacing 0.12
set xrange [0:10]; set xlabel "axial strain (%)" offset 0,0.4
set ylabel "stress ratio σ_a/σ_r" offset 0.9,0; set yrange [1:5]
set key bottom right
plot for [k = 1:3] ensemble(word(pressures, k)) using 1:($2 - $3):($2 + $3) with filledcurves fillcolor rgb colour(k), \
  for [k = 1:3] ensemble(word(pressures, k)) using 1:2 with lines linewidth 2.2 linecolor rgb colour(k) \
    title word(pressures, k) . " MPa", \
  for [k = 1:2] lab(word(pressures, k)) using 1:3 every 3 with points pointtype 6 pointsize 0.6 linecolor rgb colour(k), \
  keyentry with points pointtype 6 pointsize 0.7 linecolor rgb grey title "Toyoura sand"
set ylabel "volumetric strain ε_v (%)" offset 0.9,0; set yrange [-4.5:1.5]
set key bottom left
plot for [k = 1:3] ensemble(word(pressures, k)) using 1:($4 - $5):($4 + $5) with filledcurves fillcolor rgb colour(k), \
  for [k = 1:3] ensemble(word(pressures, k)) using 1:4 with lines linewidth 2.2 linecolor rgb colour(k) \
    title word(pressures, k) . " MPa", \
  for [k = 1:2] lab(word(pressures, k)) using 1:4 every 3 with points pointtype 6 pointsize 0.6 linecolor rgb colour(k), \
  keyentry with points pointtype 6 pointsize 0.7 linecolor rgb grey title "Toyoura sand"
unset multiplot

# --- Fabric anisotropies and the stress-force-fabric relation
@start
set output sprintf("%s/fabric.%s", out, format)
set multiplot layout 1,2 margins 0.095,0.985,0.15,0.91 spacing 0.12
set xrange [0:10]; set xlabel "axial strain (%)" offset 0,0.4; set yrange [0:2.8]; set key top right
set title "Anisotropies, 0.2 MPa"
set ylabel "anisotropy" offset 0.9,0
table = run("0.2", "shear_fabric")
plot table using (100 * column("strain_axial [1]")):(column("a_c [1]")) with linespoints pointtype 7 pointsize 0.5 linewidth 1.8 linecolor rgb blue \
    title "a_c contact normals", \
  "" using (100 * column("strain_axial [1]")):(column("a_n [1]")) with linespoints pointtype 7 pointsize 0.5 linewidth 1.8 linecolor rgb orange \
    title "a_n normal forces", \
  "" using (100 * column("strain_axial [1]")):(column("a_t [1]")) with linespoints pointtype 7 pointsize 0.5 linewidth 1.8 linecolor rgb green \
    title "a_t tangential forces"
set title "Stress–force–fabric"
set ylabel "q/p" offset 0.9,0; set key bottom right; set yrange [0:1.8]
plot for [k = 1:3] run(word(pressures, k), "shear_fabric") using (100 * column("strain_axial [1]")):(column("stress_obliquity [1]")) \
    with lines linewidth 2.2 linecolor rgb colour(k) title word(pressures, k) . " MPa", \
  for [k = 1:3] run(word(pressures, k), "shear_fabric") using (100 * column("strain_axial [1]")):(column("stress_obliquity_from_fabric [1]")) \
    with points pointtype 6 pointsize 0.7 linecolor rgb colour(k), \
  keyentry with points pointtype 6 pointsize 0.7 linecolor rgb grey title "2/5 (a_c + a_n + 3/2 a_t)"
unset multiplot; unset title

# --- Coordination number and void ratio
@start
set output sprintf("%s/state.%s", out, format)
set multiplot layout 1,2 margins 0.095,0.985,0.15,0.96 spacing 0.12
set ylabel "void ratio" offset 0.9,0; set yrange [*:*]; set key top left
plot for [k = 1:3] ensemble(word(pressures, k)) using 1:($6 - $7):($6 + $7) with filledcurves fillcolor rgb colour(k), \
  for [k = 1:3] ensemble(word(pressures, k)) using 1:6 with lines linewidth 2.2 linecolor rgb colour(k) \
    title word(pressures, k) . " MPa"
set ylabel "coordination number" offset 0.9,0; set key top right; set yrange [2.5:6.5]
plot for [k = 1:3] ensemble(word(pressures, k)) using 1:8 with lines linewidth 2.2 linecolor rgb colour(k) \
    title word(pressures, k) . " MPa", \
  for [k = 1:3] ensemble(word(pressures, k)) using 1:10 with lines dashtype 2 linewidth 1.6 linecolor rgb colour(k), \
  keyentry with lines dashtype 2 linewidth 1.6 linecolor rgb grey title "without rattlers"
unset multiplot

# --- Energy balance of one run
W = 900; H = 420; @start
set output sprintf("%s/energy.%s", out, format)
set margins 9,3,3.5,1.5
set ylabel "energy (J)" offset 0.9,0; set yrange [-0.5:*]; set key top left
table = run("0.2", "shear")
plot table using (100 * column("strain_axial [1]")):(column("boundary_work [J]")) with lines linewidth 2.6 linecolor rgb "#303840" \
    title "boundary work", \
  "" using (100 * column("strain_axial [1]")):(column("frictional_dissipation [J]")) with lines linewidth 2 linecolor rgb red \
    title "sliding", \
  "" using (100 * column("strain_axial [1]")):(column("damping_dissipation [J]")) with lines linewidth 2 linecolor rgb orange \
    title "local damping", \
  "" using (100 * column("strain_axial [1]")):(column("elastic_energy [J]")) with lines linewidth 2 linecolor rgb blue \
    title "elastic", \
  "" using (100 * column("strain_axial [1]")):(column("law_energy [J]")) with lines linewidth 2 linecolor rgb violet \
    title "taken by the incremental law", \
  "" using (100 * column("strain_axial [1]")):(column("energy_error [J]")) with lines dashtype 2 linewidth 2 linecolor rgb grey \
    title "left over"
set output
