# A bob on a string: where the string is slack it flies inside the circle of the taut string. examples/scenes/slack_string.nml
set terminal svg size 420,520 fixed font 'sans-serif,13' background 'white'
set datafile separator ','
set datafile commentschars '#'
set size ratio -1
set xrange [0:1.05]
set yrange [-1.05:1.05]
set xlabel 'distance from the axis [m]'
set ylabel 'height [m]'
set parametric
set trange [-pi/2:pi/2]
set samples 200
unset key
plot cos(t), sin(t) with lines lc 'gray', \
     '< kyvadlo simulate examples/scenes/slack_string.nml' using (sqrt($2**2 + $3**2)):4 with lines lw 1.5 lc 'dark-blue'
