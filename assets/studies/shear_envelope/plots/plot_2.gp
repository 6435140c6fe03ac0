# Draws plot_2.png and plot_2.svg from plot_2.csv:
#   gnuplot plot_2.gp
# in this folder. Columns: 1 id of the curve, 2 x, 3 y, 4 and 5 ends of the bar in x,
# 6 and 7 ends of the bar in y or of the band, 8 name.

# Appearance
set encoding utf8
set minussign
set border 3 lw 0.8 lc rgb '#333333'
set tics nomirror out scale 0.6 textcolor rgb '#333333'
set grid lt 1 lw 0.4 lc rgb '#DDDDDD'
set bars small
# What is ours is filled and in colour, what is the paper's black and open or dashed. Markers: circle, square, triangle,
# diamond, triangle downward, pentagon.
ours_1 = "lc rgb '#0072B2'"; filled_1 = "pt 7 ps 1.3"; open_1 = "pt 6 ps 1.3"; dash_1 = "dt solid lw 1.8"
ours_2 = "lc rgb '#D55E00'"; filled_2 = "pt 5 ps 1.3"; open_2 = "pt 4 ps 1.3"; dash_2 = "dt (12,5) lw 1.8"
ours_3 = "lc rgb '#009E73'"; filled_3 = "pt 9 ps 1.3"; open_3 = "pt 8 ps 1.3"; dash_3 = "dt (4,4) lw 1.8"
ours_4 = "lc rgb '#CC79A7'"; filled_4 = "pt 13 ps 1.3"; open_4 = "pt 12 ps 1.3"; dash_4 = "dt (16,4,4,4) lw 1.8"
ours_5 = "lc rgb '#E69F00'"; filled_5 = "pt 11 ps 1.3"; open_5 = "pt 10 ps 1.3"; dash_5 = "dt (16,4,4,4,4,4) lw 1.8"
ours_6 = "lc rgb '#56B4E9'"; filled_6 = "pt 15 ps 1.3"; open_6 = "pt 14 ps 1.3"; dash_6 = "dt (30,7) lw 1.8"
paper = "lc rgb '#000000'"; fit_dash_1 = "dt (6,4) lw 1.3"; fit_dash_2 = "dt (12,4,2,4) lw 1.3"
paper_dash_1 = "dt (14,8) lw 1.8"; paper_dash_2 = "dt (3,5) lw 1.8"; paper_dash_3 = "dt (18,5,3,5) lw 1.8"
paper_line = "lw 1.4 dt (14,8) lc rgb '#000000'"; guide_line = "lw 0.8 dt solid lc rgb '#999999'"
paper_band = "fs transparent solid 0.15 noborder fc rgb '#000000'"
guide_band = "fs transparent solid 0.07 noborder fc rgb '#000000'"
grey = "textcolor rgb '#444444'"
set tmargin at screen 0.9627329192546584
set bmargin at screen 0.2795031055900621
set key at screen 0.5, screen 0.08074534161490683 top center vertical maxrows 1 Left reverse samplen 3 spacing 1.1
# Axis x
set xlabel 'normal force of the piston [{/:Italic F}_{g}]'
set xrange [360:4140]
set format x '%h'
set xlabel offset 0, 0.3
# Axis y
set ylabel 'largest mean over 5 {/:Italic d} in the first slide [{/:Italic F}_{g}]'
set yrange [106.16488981283574:1490.0884449683638]
set format y '%h'
# What is drawn; pick(i, value) is the value in rows of curve i, and nothing elsewhere
set datafile separator comma
data = 'plot_2.csv'
pick(i, value) = column(1) == i ? value : NaN

# Pictures
set terminal pngcairo size 1600,966 font 'Roboto,16' fontscale 2 linewidth 2 pointscale 2 enhanced
set output 'plot_2.png'
plot data using (pick(1, column(2))):(pick(1, column(3))):(pick(1, column(6))):(pick(1, column(7))) with yerrorbars dt solid lw 1 ps 0 @ours_1 notitle, \
     data using (pick(1, column(2))):(pick(1, column(3))) with linespoints @dash_1 @filled_1 @ours_1 title 'cohesion force 0 {/:Italic F}_{g}', \
     data using (pick(2, column(2))):(pick(2, column(3))):(pick(2, column(6))):(pick(2, column(7))) with yerrorbars dt solid lw 1 ps 0 @ours_2 notitle, \
     data using (pick(2, column(2))):(pick(2, column(3))) with linespoints @dash_2 @filled_2 @ours_2 title 'cohesion force 100 {/:Italic F}_{g}'
set terminal svg size 800,483 font 'Roboto,Helvetica,Arial,sans-serif,21' enhanced background rgb 'white'
set output 'plot_2.svg'
replot
