# Figures of chapter 2: thesis Figs. 2.1 to 2.4, posterior densities, effective sample size.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: gnuplot -e "out='out/ch2'; format='svg'; cases='hm_1000_0.2 ...'; checked='...'; rounds='1 2'; last='2'; until=6" figures.gp
set datafile separator "\t"
set datafile commentschars "#"
set encoding utf8
part(c, k) = word(system("echo " . c . " | tr _ ' '"), k)
steps(c, r) = sprintf("%s/%s/steps%s.tsv", out, c, r)
density(c, r) = sprintf("%s/%s/density%s.tsv", out, c, r)
# Series of the identified set (00000?) or of the thesis's (000010), those that are there.
runs(c, which) = system(sprintf("ls %s/%s/check/runs/%s/series.tsv 2>/dev/null || true", out, c, which))
later = system("for r in " . rounds . "; do [ $r = 1 ] || printf '%s ' $r; done")
lab(p) = sprintf("data/laboratory/toyoura_drained_triaxial_%sMPa.tsv", p)
blue = "#1f6fb2"; orange = "#d9772b"; green = "#2f8f6b"; grey = "#667080"; red = "#b5394e"; violet = "#7458a6"
colours = blue . " " . orange . " " . green . " " . red . " " . violet . " " . grey
names = "young_modulus poisson_ratio rolling_stiffness rolling_limit friction_angle"
units = "Pa 1 1 1 deg"
axis(k) = word("E_(GPa) ν rolling_stiffness rolling_limit friction_angle_(°)", k)
label_of(k) = system("echo '" . axis(k) . "' | tr _ ' '")
scaled(k, x) = k == 1 ? x / 1e9 : x
head(k) = word(names, k) . " [" . word(units, k) . "]"
law_name(l) = l eq "hm" ? "Hertz–Mindlin" : "linear"

start = 'if (format eq "svg") { set terminal svg size W,H font "Helvetica,14" background "#ffffff" rounded } else { \
  set terminal pngcairo size 2*W,2*H font "Helvetica,14" fontscale 1.9 linewidth 2 pointscale 1.7 background "#ffffff" rounded }'
figure(name) = sprintf("%s/%s.%s", out, name, format)
set border 3 linecolor rgb "#505860" linewidth 1
set xtics nomirror out scale 0.6 textcolor rgb "#303840"
set ytics nomirror out scale 0.6 textcolor rgb "#303840"
set grid linecolor rgb "#e3e6ea" linewidth 0.8 linetype 1
set key noautotitle Left reverse spacing 1.15 samplen 1.6 width -2 textcolor rgb "#303840"
set style fill transparent solid 0.15 noborder

# Cases of one law at 0.2 MPa, by grains; of one number of grains, by pressure.
select(list, l, p) = system(sprintf("for c in %s; do case $c in %s_*_%s) printf '%%s ' $c;; esac; done", list, l, p))

# --- Figs. 2.1 and 2.2: weighted means over axial strain, first round
do for [l in "cl hm"] {
  group = select(cases, l, "0.2")
  if (words(group) > 0) {
    W = 900; H = 560; @start
    set output figure("means_" . l)
    set multiplot layout 2,3 margins 0.085,0.97,0.12,0.97 spacing 0.11,0.15
    set xrange [0:until]; set yrange [*:*]
    do for [k = 1:5] {
      set xlabel (k > 2 ? "axial strain (%)" : "") offset 0,0.4; set ylabel label_of(k) offset 0.9,0
      if (k == 1) { set logscale y } else { unset logscale y }
      plot for [i = 1:words(group)] steps(word(group, i), "1") using (column("strain_axial [%]")):(scaled(k, column(head(k)))) with lines \
          linewidth 2 linecolor rgb word(colours, i), \
        for [i = 1:words(group)] for [r in later] steps(word(group, i), r) using \
          (column("strain_axial [%]")):(scaled(k, column(head(k)))) with lines dashtype 2 linewidth 1.6 linecolor rgb word(colours, i)
    }
    unset logscale y; unset border; unset tics; unset grid; unset xlabel; unset ylabel; set key center center
    set xrange [0:1]; set yrange [0:1]
    plot -1 with lines, for [i = 1:words(group)] keyentry with lines linewidth 2 linecolor rgb word(colours, i) title part(word(group, i), 2) . " grains", \
      keyentry with lines dashtype 2 linewidth 1.6 linecolor rgb grey title "after resampling"
    unset multiplot
    set border 3; set tics; set xtics nomirror out scale 0.6; set ytics nomirror out scale 0.6; set grid; set key top right
  }
}

# --- Fig. 2.3: identified means over confining pressure
do for [l in "hm cl"] {
  group = system(sprintf("for c in %s; do case $c in %s_1000_*) printf '%%s ' $c;; esac; done", cases, l))
  if (words(group) > 2) {
    W = 900; H = 560; @start
    set output figure("pressure_" . l)
    set print sprintf("%s/pressure_%s.tsv", out, l)
    do for [c in group] {
      line = system(sprintf("tail -n 1 %s", steps(c, last)))
      header = system(sprintf("head -n 1 %s", steps(c, last)))
      print part(c, 3) . "\t" . system(sprintf("awk -F '\\t' -v names='%s' 'NR == 1 { for (i = 1; i <= NF; ++i) { k = $i; sub(/ .*/, \"\", k); at[k] = i } n = split(names, name, \" \") } { row = $0 } END { split(row, v, FS); for (k = 1; k <= n; ++k) printf \"%%s\\t\", v[at[name[k]]] }' %s", names, steps(c, last)))
    }
    unset print
    set multiplot layout 2,3 margins 0.085,0.97,0.12,0.97 spacing 0.11,0.15
    set logscale x 2; set xrange [0.15:11]; set yrange [*:*]
    do for [k = 1:5] {
      set xlabel "confining pressure (MPa)" offset 0,0.4; set ylabel label_of(k) offset 0.9,0
      plot sprintf("%s/pressure_%s.tsv", out, l) using 1:(scaled(k, column(k + 1))) with linespoints pointtype 7 linewidth 2 linecolor rgb blue
    }
    unset multiplot; unset logscale x
  }
}

# --- Fig. 2.4: the test with the identified parameters, and with the thesis's
n = words(checked)
W = 900; H = 400 * n; @start
set output figure("prediction")
set multiplot layout n,2 margins 0.095,0.985,0.15 / n,1 - 0.10 / n spacing 0.12,0.30 / n
set xrange [0:9]
do for [c in checked] {
  p = part(c, 3)
  set title sprintf("%s, %s grains, %s MPa", law_name(part(c, 1)), part(c, 2), p)
  set xlabel "axial strain (%)" offset 0,0.4
  set ylabel "stress ratio σ_a/σ_r" offset 0.9,0; set yrange [1:5]; set key bottom right
  shear(y) = column("stage [1]") == 1 ? y : NaN
  identified = runs(c, "00000?"); thesis = runs(c, "000010")
  plot lab(p) using 1:3 every 3 with points pointtype 6 pointsize 0.6 linecolor rgb "#303840" title "Toyoura sand", \
    for [file in identified] file using (100 * column("strain_axial [1]")):(shear(column("stress_ratio [1]"))) with lines \
      linewidth 2 linecolor rgb blue, \
    for [file in thesis] file using (100 * column("strain_axial [1]")):(shear(column("stress_ratio [1]"))) with lines dashtype 2 linewidth 1.8 \
      linecolor rgb orange, \
    keyentry with lines linewidth 2 linecolor rgb blue title "identified, twins", \
    keyentry with lines dashtype 2 linewidth 1.8 linecolor rgb orange title "thesis's set"
  set ylabel "volumetric strain ε_v (%)" offset 0.9,0; set yrange [*:*]; set key bottom left
  plot lab(p) using 1:4 every 3 with points pointtype 6 pointsize 0.6 linecolor rgb "#303840", \
    for [file in identified] file using (100 * column("strain_axial [1]")):(shear(100 * column("strain_volumetric [1]"))) with lines \
      linewidth 2 linecolor rgb blue, \
    for [file in thesis] file using (100 * column("strain_axial [1]")):(shear(100 * column("strain_volumetric [1]"))) with lines dashtype 2 linewidth 1.8 \
      linecolor rgb orange
}
unset multiplot; unset title

# --- Posterior densities at several strains of the first round, and of all rounds at the end
do for [c in checked] {
  W = 900; H = 560; @start
  set output figure("density_" . c)
  set multiplot layout 2,3 margins 0.085,0.97,0.12,0.97 spacing 0.11,0.15
  set xrange [*:*]; set yrange [0:*]; set key top right
  stations = system(sprintf("awk -F '\\t' 'NR > 1 && !seen[$2]++ { printf \"%%s \", $2 }' %s", density(c, "1")))
  do for [k = 1:5] {
    if (k == 1) { set logscale x } else { unset logscale x }
    if (k == 1 || k == 5) { set xtics autofreq } else { set xtics 0.1 }
    set xlabel label_of(k) offset 0,0.4; set ylabel (k == 1 || k == 4 ? "density" : "") offset 0.9,0
    plot for [i = 1:words(stations)] density(c, "1") using \
        (column("parameter [1]") == k - 1 && abs(column("strain_axial [%]") - word(stations, i)) < 1e-9 ? scaled(k, column("value [its own]")) : NaN): \
        (column("density [1 per its own]")) with lines linewidth 1.8 linecolor rgb word(colours, i), \
      density(c, last) using (column("parameter [1]") == k - 1 && abs(column("strain_axial [%]") - word(stations, words(stations))) < 1e-9 ? \
        scaled(k, column("value [its own]")) : NaN):(column("density [1 per its own]")) with lines dashtype 2 linewidth 1.8 linecolor rgb "#303840"
  }
  unset logscale x; set xtics autofreq; unset border; unset tics; unset grid; unset xlabel; unset ylabel; set key center center
  set xrange [0:1]; set yrange [0:1]
  plot -1 with lines, for [i = 1:words(stations)] keyentry with lines linewidth 1.8 linecolor rgb word(colours, i) title sprintf("to %.2g %% strain", word(stations, i) + 0), \
    keyentry with lines dashtype 2 linewidth 1.8 linecolor rgb "#303840" title "all rounds, at the end"
  unset multiplot
  set border 3; set tics; set xtics nomirror out scale 0.6; set ytics nomirror out scale 0.6; set grid; set key top right
}

# --- Effective sample size over axial strain
W = 640; H = 420; @start
set output figure("size")
set xlabel "axial strain (%)" offset 0,0.4; set ylabel "effective sample size" offset 0.9,0
set xrange [0:until]; set yrange [0.9:*]; set logscale y
plot for [i = 1:words(checked)] steps(word(checked, i), "1") using (column("strain_axial [%]")):(column("effective_size [1]")) with lines linewidth 2 \
    linecolor rgb word(colours, i) title sprintf("%s, %s grains, %s MPa", law_name(part(word(checked, i), 1)), part(word(checked, i), 2), part(word(checked, i), 3)), \
  for [i = 1:words(checked)] steps(word(checked, i), last) using (column("strain_axial [%]")):(column("effective_size [1]")) with lines dashtype 2 \
    linewidth 1.8 linecolor rgb word(colours, i), \
  keyentry with lines dashtype 2 linewidth 1.8 linecolor rgb grey title "all rounds"
set output
