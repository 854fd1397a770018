# The period of every orbit of a pendulum of 1 m, over its turning heights, from a sweep. Where there is no orbit it is white.
set terminal svg size 640,480 fixed font 'sans-serif,13' background 'white'
set datafile separator ','
set xlabel 'upper turning height [m]'
set ylabel 'lower turning height [m]'
set cblabel 'period of the height [s]'
set palette defined (0 '#30123b', 1 '#4686fb', 2 '#1ae4b6', 3 '#a4fc3c', 4 '#fb7e21', 5 '#7a0403')
set xrange [-0.975:0.975]
set yrange [-1.025:0.025]
set key off
plot '< kyvadlo sweep examples/sweeps/periods.nml' skip 1 using 1:2:(0.025):(0.025):3 with boxxyerror \
     fillstyle solid linecolor palette
