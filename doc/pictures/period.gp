# The period of a pendulum of 1 m over its upper turning height, for some lower ones, from grids of the program.
set terminal svg size 640,420 fixed font 'sans-serif,13' background 'white'
set datafile separator ','
set xlabel 'upper turning height [m]'
set ylabel 'period of the height [s]'
set key bottom left title 'lower turning height'
set grid
plot for [z in "-0.95 -0.8 -0.6 -0.4"] \
     sprintf('< kyvadlo table --upper=%s:%g:101 --lower=%s:%s:1 --format csv', z, -z - 0.005, z, z) \
     skip 1 using 1:3 with lines lw 2 title z.' m'
