# Height and azimuth over one period, of the pendulum "wide swing" of examples/scenes/laboratory.nml.
set terminal svg size 640,420 fixed font 'sans-serif,13' background 'white'
set datafile separator ','
set xlabel 'time [s]'
set ylabel 'height z [m]'
set y2label 'azimuth [degrees]'
set ytics nomirror
set y2tics 0,90,360
set y2range [0:360]
set key top center
table = "< kyvadlo table examples/scenes/laboratory.nml --divisions 200 --format csv | grep '^wide swing,'"
plot table using 3:4 with lines lw 2 title 'height', \
     table using 3:10 axes x1y2 with lines lw 2 title 'azimuth'
