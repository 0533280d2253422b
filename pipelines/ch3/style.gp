# What the figures of chapter 3 share; loaded before them: gnuplot -e "out='DIR'; format='svg'; loads='1330 ...'; yarns=1; end='20'" style.gp ...
# SPDX-License-Identifier: GPL-3.0-or-later
set datafile separator "\t"
set key autotitle columnhead
if (format eq 'svg') { set terminal svg size 900,380 dynamic font 'sans,12' } else { set terminal pngcairo size 1800,760 font 'sans,22' }
set key left top Left reverse samplen 2 noautotitle
# A run and its record share a colour.
hue(g) = g eq 'PP' ? 2 : 1
C(n) = column(n)
