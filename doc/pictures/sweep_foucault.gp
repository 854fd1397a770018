# Where the line of a Foucault pendulum's swing lies after a minute, over the push across that makes it an ellipse, for some
# amplitudes, from a sweep.
set terminal svg size 640,420 fixed font 'sans-serif,13' background 'white'
set datafile separator ','
set xlabel 'push across the swing [m/s]'
set ylabel 'azimuth of the line of the swing after a minute [degrees]'
set key top left title 'amplitude'
set grid
plot for [a in "1 2 4 8"] \
     sprintf("< kyvadlo sweep examples/sweeps/foucault.nml | awk -F, '$1 == %s'", a) \
     using 2:(180/pi*$3) with linespoints lw 2 pt 7 ps 0.5 title a.' degrees'
