# The quickstart study's figures, as SVG and PNG. Usage: gnuplot -e "dir='DIRECTORY'" figures.gp
# SPDX-License-Identifier: GPL-3.0-or-later
set datafile separator '\t'
set datafile commentschars '#'
set border 3 lc rgb '#555555'
set tics nomirror
set grid lc rgb '#e6e6e6' lt 1
set key noautotitle samplen 2
blue = '#2166ac'; orange = '#d6604d'; green = '#1b7837'; grey = '#777777'
lab = 'data/laboratory/toyoura_drained_triaxial_'

do for [form in "svg png"] {
  if (form eq 'svg') { set terminal svg size 760,430 enhanced font 'Helvetica,14' background 'white' }
  else { set terminal pngcairo size 1140,645 enhanced font 'Helvetica,19' background 'white' }

  set output sprintf('%s/stress_ratio.%s', dir, form)
  set xlabel 'axial strain (%)'; set ylabel 'stress ratio σ_a/σ_r'; set xrange [0:10]; set yrange [1:5.2]
  set key bottom right
  plot dir.'/ensemble_0.2.tsv' using 1:($2-$3):($2+$3) skip 1 with filledcurves fc rgb blue fs transparent solid 0.25, \
       dir.'/ensemble_0.5.tsv' using 1:($2-$3):($2+$3) skip 1 with filledcurves fc rgb orange fs transparent solid 0.25, \
       dir.'/ensemble_1.0.tsv' using 1:($2-$3):($2+$3) skip 1 with filledcurves fc rgb green fs transparent solid 0.25, \
       dir.'/ensemble_0.2.tsv' using 1:2 skip 1 with lines lw 2 lc rgb blue title 'DEM, 0.2 MPa (mean and scatter of twins)', \
       dir.'/ensemble_0.5.tsv' using 1:2 skip 1 with lines lw 2 lc rgb orange title 'DEM, 0.5 MPa', \
       dir.'/ensemble_1.0.tsv' using 1:2 skip 1 with lines lw 2 lc rgb green title 'DEM, 1.0 MPa', \
       lab.'0.2MPa.tsv' using 1:3 every 4 skip 1 with points pt 6 lc rgb blue title 'Toyoura sand, 0.2 MPa', \
       lab.'0.5MPa.tsv' using 1:3 every 4 skip 1 with points pt 4 lc rgb orange title 'Toyoura sand, 0.5 MPa'

  set output sprintf('%s/volumetric_strain.%s', dir, form)
  set ylabel 'volumetric strain (%)'; set yrange [1:-5]; set key top left
  plot dir.'/ensemble_0.2.tsv' using 1:($4-$5):($4+$5) skip 1 with filledcurves fc rgb blue fs transparent solid 0.25, \
       dir.'/ensemble_0.5.tsv' using 1:($4-$5):($4+$5) skip 1 with filledcurves fc rgb orange fs transparent solid 0.25, \
       dir.'/ensemble_1.0.tsv' using 1:($4-$5):($4+$5) skip 1 with filledcurves fc rgb green fs transparent solid 0.25, \
       dir.'/ensemble_0.2.tsv' using 1:4 skip 1 with lines lw 2 lc rgb blue title 'DEM, 0.2 MPa', \
       dir.'/ensemble_0.5.tsv' using 1:4 skip 1 with lines lw 2 lc rgb orange title 'DEM, 0.5 MPa', \
       dir.'/ensemble_1.0.tsv' using 1:4 skip 1 with lines lw 2 lc rgb green title 'DEM, 1.0 MPa', \
       lab.'0.2MPa.tsv' using 1:4 every 4 skip 1 with points pt 6 lc rgb blue title 'Toyoura sand, 0.2 MPa', \
       lab.'0.5MPa.tsv' using 1:4 every 4 skip 1 with points pt 4 lc rgb orange title 'Toyoura sand, 0.5 MPa'

  set output sprintf('%s/anisotropy.%s', dir, form)
  set ylabel 'anisotropy'; set yrange [0:2]; set key top right
  plot dir.'/fabric.tsv' using (100*column('strain_axial [1]')):(column('a_n [1]')) with linespoints pt 7 lw 2 lc rgb blue title 'a_n, normal forces', \
       dir.'/fabric.tsv' using (100*column('strain_axial [1]')):(column('a_c [1]')) with linespoints pt 5 lw 2 lc rgb green title 'a_c, contact normals', \
       dir.'/fabric.tsv' using (100*column('strain_axial [1]')):(column('a_t [1]')) with linespoints pt 9 lw 2 lc rgb orange title 'a_t, tangential forces', \
       dir.'/fabric.tsv' using (100*column('strain_axial [1]')):(column('stress_obliquity [1]')) with lines lw 2 lc rgb grey title 'q/p from the stress', \
       dir.'/fabric.tsv' using (100*column('strain_axial [1]')):(column('stress_obliquity_from_fabric [1]')) with points pt 2 lc rgb grey title '2/5 (a_c + a_n + 3/2 a_t)'

  set output sprintf('%s/coordination.%s', dir, form)
  set ylabel 'coordination number, rattlers apart'; set yrange [3.5:6.5]
  plot for [i=1:3] dir.'/ensemble_'.word('0.2 0.5 1.0', i).'.tsv' using 1:6 skip 1 with lines lw 2 lc rgb word(blue.' '.orange.' '.green, i) title word('0.2 0.5 1.0', i).' MPa'

  set output sprintf('%s/energy.%s', dir, form)
  set ylabel 'energy (J)'; set yrange [*:*]; set key top left
  e = dir.'/energy.tsv'
  s = "column('stage [1]') == 1 ? 100*column('strain_axial [1]') : NaN"
  plot e using (@s):(column('boundary_work [J]')) with lines lw 3 lc rgb grey title 'work of the cell', \
       e using (@s):(column('frictional_dissipation [J]')) with lines lw 2 lc rgb orange title 'friction', \
       e using (@s):(column('damping_dissipation [J]')) with lines lw 2 lc rgb blue title 'local damping', \
       e using (@s):(column('elastic_energy [J]')) with lines lw 2 lc rgb green title 'elastic', \
       e using (@s):(column('law_energy [J]')) with lines lw 2 dt 2 lc rgb 'black' title 'incremental law itself'

  set output sprintf('%s/histogram.%s', dir, form)
  set xlabel 'contacts of a grain'; set ylabel 'grains'; set xrange [-0.6:12.6]; set yrange [0:*]; set style fill solid 0.7
  plot dir.'/histogram.tsv' using (column('contacts [1]')):(column('grains [1]')) with boxes lc rgb blue

  set output sprintf('%s/rose.%s', dir, form)
  unset border; unset tics; unset xlabel; unset ylabel; unset grid
  set polar; set angles degrees; set size square; set rrange [0:1.5]; set trange [0:360]
  set xrange [-1.6:1.6]; set yrange [-1.6:1.6]; set grid polar 30 lc rgb '#dddddd'; set rtics 0.5 format '%.1f'
  set key top left
  plot 1 with lines lc rgb grey dt 2 title 'isotropic', \
       dir.'/rose.tsv' using (column('plane [1]') == 2 ? column('angle [deg]') : NaN):(column('density [1]')) with filledcurves closed fc rgb blue fs transparent solid 0.4 title 'contact normals, x-z plane'
  unset polar; set size nosquare; unset rrange; unset trange; unset rtics; unset angles
  set border 3 lc rgb '#555555'; set tics nomirror; set xtics auto; set ytics auto; set grid nopolar; set grid x y lc rgb '#e6e6e6' lt 1
}
