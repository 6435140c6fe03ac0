# How plots look: the pieces, each below its name, from which a script is put together. Names in braces stand for
# what the plot shows.
#% head
# Draws {{name}}.png and {{name}}.svg from {{name}}.csv:
#   gnuplot {{name}}.gp
# in this folder. Columns: 1 id of the curve, 2 x, 3 y, 4 and 5 ends of the bar in x,
# 6 and 7 ends of the bar in y or of the band, 8 name.

# Appearance
set encoding utf8
set minussign
set border {{borders}} lw 0.8 lc rgb '#333333'
set tics nomirror out scale 0.6 textcolor rgb '#333333'
set grid lt 1 lw 0.4 lc rgb '#DDDDDD'
set bars small
# What is ours is filled and in colour, what is the paper's black and open or dashed. Markers: circle, square, triangle,
# diamond, triangle downward, pentagon.
ours_1 = "lc rgb '{{colour_1}}'"; filled_1 = "pt 7 ps 1.3"; open_1 = "pt 6 ps 1.3"; dash_1 = "dt solid lw 1.8"
ours_2 = "lc rgb '{{colour_2}}'"; filled_2 = "pt 5 ps 1.3"; open_2 = "pt 4 ps 1.3"; dash_2 = "dt (12,5) lw 1.8"
ours_3 = "lc rgb '{{colour_3}}'"; filled_3 = "pt 9 ps 1.3"; open_3 = "pt 8 ps 1.3"; dash_3 = "dt (4,4) lw 1.8"
ours_4 = "lc rgb '{{colour_4}}'"; filled_4 = "pt 13 ps 1.3"; open_4 = "pt 12 ps 1.3"; dash_4 = "dt (16,4,4,4) lw 1.8"
ours_5 = "lc rgb '{{colour_5}}'"; filled_5 = "pt 11 ps 1.3"; open_5 = "pt 10 ps 1.3"; dash_5 = "dt (16,4,4,4,4,4) lw 1.8"
ours_6 = "lc rgb '{{colour_6}}'"; filled_6 = "pt 15 ps 1.3"; open_6 = "pt 14 ps 1.3"; dash_6 = "dt (30,7) lw 1.8"
paper = "lc rgb '#000000'"; fit_dash_1 = "dt (6,4) lw 1.3"; fit_dash_2 = "dt (12,4,2,4) lw 1.3"
paper_dash_1 = "dt (14,8) lw 1.8"; paper_dash_2 = "dt (3,5) lw 1.8"; paper_dash_3 = "dt (18,5,3,5) lw 1.8"
paper_line = "lw 1.4 dt (20,7,4,7,4,7) lc rgb '#000000'"; guide_line = "lw 0.8 dt solid lc rgb '#999999'"
paper_band = "fs transparent solid 0.15 noborder fc rgb '#000000'"
guide_band = "fs transparent solid 0.07 noborder fc rgb '#000000'"
grey = "textcolor rgb '#444444'"
#% title
set title {{title}} offset 0, {{up}}
#% margins
set tmargin at screen {{top}}
set bmargin at screen {{bottom}}
#% left_margin
set lmargin at screen {{left}}
#% no_legend
unset key
#% legend_top_left
set key inside top left Left reverse samplen 3 spacing 1.1
#% legend_bottom_right
set key inside bottom right Left reverse samplen 3 spacing 1.1
#% legend_below
set key at screen 0.5, screen {{top}} top center vertical maxrows {{rows}} Left reverse samplen 3 spacing 1.1
#% axis
# Axis {{axis}}
set {{axis}}label {{label}} offset {{aside}}, 0
set {{axis}}range {{range}}
#% plain
set format {{axis}} '%h'
#% scientific
set format {{axis}} '%.3h'
#% x_axis
set xlabel offset 0, 0.3
#% y2_axis
set y2tics
#% logarithmic
set logscale {{axis}}
#% places
set {{axis}}tics ({{places}})
#% powers
set format {{axis}} '10^{%T}'
#% many_decades
unset m{{axis}}tics
#% x_line
set arrow from first {{low}}, graph 0 to first {{high}}, graph 1 nohead @{{role}}_line
#% y_line
set arrow from graph 0, first {{low}} to graph 1, first {{high}} nohead @{{role}}_line
#% x_band
set object rectangle from first {{low}}, graph 0 to first {{high}}, graph 1 behind @{{role}}_band
#% y_band
set object rectangle from graph 0, first {{low}} to graph 1, first {{high}} behind @{{role}}_band
#% x_name
set label {{name}} at first {{low}}, graph 1 {{side}} offset character 0, {{up}} @grey
#% y_name
set label {{name}} at graph 0.99, first {{high}} right offset character 0, 0.5 @grey
#% annotation
set label {{text}} at {{x}}, {{y}} {{side}} offset {{aside}}, {{up}} front @grey
#% data
# What is drawn; pick(i, value) is the value in rows of curve i, and nothing elsewhere
set datafile separator comma
data = '{{name}}.csv'
pick(i, value) = column(1) == i ? value : NaN

# Pictures
set terminal pngcairo size {{double_width}},{{double_height}} font 'Roboto,16' fontscale 2 linewidth 2 pointscale 2 enhanced
set output '{{name}}.png'
plot {{elements}}
set terminal svg size {{width}},{{height}} font 'Roboto,Helvetica,Arial,sans-serif,21' enhanced background rgb 'white'
set output '{{name}}.svg'
replot
#% x
data using (pick({{id}}, column(2)))
#% y
:(pick({{id}}, column(3)))
#% y_of_band
:(pick({{id}}, column(6))):(pick({{id}}, column(7)))
#% ends_x
:(pick({{id}}, column(4))):(pick({{id}}, column(5)))
#% ends_y
:(pick({{id}}, column(6))):(pick({{id}}, column(7)))
#% x_bars
with xerrorbars dt solid lw 1 ps 0 {{colour}}
#% y_bars
with yerrorbars dt solid lw 1 ps 0 {{colour}}
#% points
with points lw 1.3 @{{marker}} {{colour}}
#% line
with lines @{{dash}} {{colour}}
#% line_points
with linespoints @{{dash}} @{{marker}} {{colour}}
#% steps
with steps @{{dash}} {{colour}}
#% band
with filledcurves fs transparent solid 0.2 noborder {{colour}}
#% boxes
with boxxyerror fs transparent solid 0.2 noborder {{colour}}
#% dots
with points pt 6 ps 0.6 lw 1 {{colour}}
#% share_x
data using (pick({{id}}, column(2))):(pick({{id}}, {{place}})) with lines lt nodraw notitle
#% share_y
data using (pick({{id}}, {{place}})):(pick({{id}}, column(3))) with lines lt nodraw notitle
#% key_line
NaN with lines @{{role}}_line title {{name}}
#% key_band
NaN with filledcurves @{{role}}_band title {{name}}
