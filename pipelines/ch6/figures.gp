# Figures of chapter 6: thesis Figs. 6.2 to 6.6.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: gnuplot -e "out='out/ch6'; format='svg'; main='8_0.5'; shapes='6_1 8_1 ...'; pullouts='6_1 ...'" figures.gp
# format: svg or png. Tables and figures lie in the same folder; an example whose main run is not there has the first figure alone.
set datafile separator "\t"
set encoding utf8
start = 'if (format eq "svg") { set terminal svg size W,H font "Helvetica,14" background "#ffffff" rounded } else { \
  set terminal pngcairo size 2*W,2*H font "Helvetica,14" fontscale 1.9 linewidth 2 pointscale 1.7 background "#ffffff" rounded }'
figure(name) = sprintf("%s/%s.%s", out, name, format)
series(example, c) = sprintf("%s/%s_%s.tsv", out, example, c)
rows_of(example, name) = sprintf("%s/%s_%s_%s.tsv", out, example, main, name)
squares(c) = int(substr(c, 1, strstrt(c, "_") - 1))
speed(c) = substr(c, strstrt(c, "_") + 1, strlen(c))
label(c) = sprintf("%d elements, %s cm/s", 2 * squares(c) * squares(c), speed(c))
absolute(x) = x < 0 ? -x : x
set border 3 linecolor rgb "#505860" linewidth 1
set xtics nomirror out scale 0.6; set ytics nomirror out scale 0.6
set grid linecolor rgb "#e3e6ea" linewidth 0.8 linetype 1
set key noautotitle Left reverse top left samplen 1.6

# --- Fig. 6.2: the global responses
W = 1000; H = 420; @start
set output figure("global")
set multiplot layout 1,2
set xlabel "pulled (cm)"
set title "shape-forming"; set ylabel "vertical stress at the bottom (kPa)"; set yrange [0:*]; set key top left
plot for [c in shapes] series("shape", c) using (100 * column("pull_end [m]")): \
  (absolute(column("force_y_bottom [N m-1]")) / column("length_bottom [m]") / 1e3) with lines linewidth 1.6 title label(c)
set title "pull-out"; set ylabel "friction ratio at the bottom"; set key bottom right
plot for [c in pullouts] series("pullout", c) using (100 * column("pull_end [m]")): \
  (-column("interface_shear [N m-1]") / column("interface_normal [N m-1]")) with lines linewidth 1.6 title label(c)
unset multiplot; unset title; set key top left

mains = system(sprintf("cd %s && for e in shape pullout; do [ ! -e ${e}_%s_fields.tsv ] || printf '%%s ' $e; done", out, main))

# --- Figs. 6.3, 6.4: fields of the last state, how the nodes have moved, the bars
set palette defined (0 "#440154", 0.25 "#3b528b", 0.5 "#21918c", 0.75 "#5ec962", 1 "#fde725")
do for [example in mains] {
  stats rows_of(example, "last_nodes") using (sqrt(column("displacement_x [m]")**2 + column("displacement_y [m]")**2)) nooutput
  magnified = STATS_max < 0.05 && STATS_max > 0 ? 10**floor(log10(0.2 / STATS_max)) : 1
  W = 1200; H = 720; @start
  set output figure(example . "_fields")
  set multiplot layout 2,3 margins 0.04,0.93,0.06,0.94 spacing 0.13,0.14
  set size ratio -1; set key off; set autoscale; unset xlabel; unset ylabel; unset grid
  set xtics 0.4; set ytics 0.4; set xrange [-0.15:1.45]; set yrange [(example eq "shape" ? -0.3 : -0.1):1.35]
  do for [k = 1:6] {
    set title word("p q ε_q rotation F_a ε_v", k) . (k < 3 ? " (kPa)" : k == 4 ? " (rad)" : k == 5 ? "" : " (%)")
    if (k == 5) { set cbrange [0:*] } else { set cbrange [*:*] }
    if (k == 1 && magnified > 1) { set label 1 sprintf("displacements × %g", magnified) at 1.45, 1.29 right font ",11" } else { unset label 1 }
    factor = k < 3 ? 1e-3 : k == 3 || k == 6 ? 100 : 1
    plot rows_of(example, "fields") skip 1 using 1:2:(factor * column(k + 2)) with filledcurves closed \
        fillcolor palette, \
      rows_of(example, "last_nodes") using (column("x [m]") - column("displacement_x [m]")): \
        (column("y [m]") - column("displacement_y [m]")):(magnified * column("displacement_x [m]")): \
        (magnified * column("displacement_y [m]")) \
        with vectors head size 0.01,20,60 linecolor rgb "#202020" linewidth 0.8, \
      rows_of(example, "last_bars") using (column("x_0 [m]")):(column("y_0 [m]")) with points \
        pointtype 7 pointsize 0.25 linecolor rgb "#c03020"
  }
  unset multiplot
  set size noratio; set autoscale; set xtics autofreq; set ytics autofreq; set key on; unset title; set grid
}

# --- Figs. 6.5, 6.6: local responses
do for [example in mains] {
  W = 1200; H = 380; @start
  set xtics rotate by -40
  set output figure(example . "_local")
  local = rows_of(example, "local")
  set multiplot layout 1,3
  set key off
  set xlabel "ε_q (%)"; set ylabel "q/p"; set y2label "ε_v (%)"; set y2tics
  plot local using (100 * column("strain_shear [1]")):(column("mean_stress [Pa]") > 1 ? column("deviatoric_stress [Pa]") / \
      column("mean_stress [Pa]") : NaN) with lines linewidth 1.6 linecolor rgb "#1f6fb2", \
    local using (100 * column("strain_shear [1]")):(100 * column("strain_volumetric [1]")) axes x1y2 with lines linewidth 1.6 \
      linecolor rgb "#d9772b"
  unset y2label; unset y2tics
  set xlabel "p (kPa)"; set ylabel "q (kPa)"
  plot local using (1e-3 * column("mean_stress [Pa]")):(1e-3 * column("deviatoric_stress [Pa]")) with lines linewidth 1.6 \
    linecolor rgb "#1f6fb2"
  set xlabel "ε_q (%)"; set ylabel "F_a"
  plot local using (100 * column("strain_shear [1]")):(column("anisotropy [1]")) with lines linewidth 1.6 linecolor rgb "#2f8f6b"
  unset multiplot
}
