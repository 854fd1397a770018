# Nine periods seen from above, between the circles of the two turning heights.
set terminal svg size 520,520 fixed font 'sans-serif,13' background 'white'
set datafile separator ','
set size ratio -1
set xlabel 'x [m]'
set ylabel 'y [m]'
set parametric
set trange [0:2*pi]
set samples 200
unset key
plot sqrt(1 - 0.2**2)*cos(t), sqrt(1 - 0.2**2)*sin(t) with lines lc 'gray', \
     sqrt(1 - 0.8**2)*cos(t), sqrt(1 - 0.8**2)*sin(t) with lines lc 'gray', \
     '< orbit_to_csv -0.2 -0.8 9 200' using 2:3 with lines lw 1.5 lc 'dark-blue'
