# How fast the ellipse of a Foucault pendulum turns by itself, over its amplitude; foucault_precession.dat is written by the example.
set terminal svg size 640,420 fixed font 'sans-serif,13' background 'white'
set xlabel 'amplitude a [m]'
set ylabel 'turn of the ellipse [degrees per hour]'
set key left top
set grid
plot 'foucault_precession.dat' using 1:2 with lines lw 2 title 'exact', \
     '' using 1:3 with lines lw 2 dt 2 title "Airy's rate for small ellipses"
