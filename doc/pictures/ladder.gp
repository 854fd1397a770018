# What a position costs at an accuracy: ours from what `kyvadlo-bench --accuracy` printed into doc/speed.md (AVX-512, k**2 < 1/2),
# the others from the record of `kyvadlo study` (typical orbit, within the 1000th period).
set terminal svg size 760,460 fixed font 'sans-serif,13' background 'white'
set datafile separator whitespace
set logscale xy
set xrange [1:1e-33]
set yrange [1:2e7]
set format '10^{%L}'
set xtics (1, 1e-5, 1e-10, 1e-15, 1e-20, 1e-25, 1e-30)
set xlabel 'accuracy: asked for (kyvadlo), reached (others) [pendulum lengths]'
set ylabel 'nanoseconds a position'
set key top right
set grid
ours = "< awk '/^  accuracy/ { n++ } n == 1 && /^ +1.E-/ { print $1, $(NF - 1) }' doc/speed.md"
study(method, setting) = sprintf("< awk -F, '$1 == \"position_1000\" && $2 == \"typical\" && $3 == \"%s\" && $4 ~ /%s/ && $5 == \"real64\" && $7 != \"capped\" { print $6, $7 }' doc/study/study.csv", method, setting)
plot ours using 1:2 with linespoints lw 3 pt 7 lc rgb '#d62728' title 'kyvadlo, set up to the accuracy', \
     study('carlson_point', '.') using 1:2 with points pt 4 lw 2 lc rgb '#9467bd' title 'textbook closed form (Carlson, Legendre, GSL)', \
     study('gsl_rk8pd', 'spherical') using 1:2 with linespoints lw 2 pt 6 lc rgb '#e377c2' title 'GSL rk8pd', \
     study('gsl_msadams', 'spherical') using 1:2 with linespoints lw 2 pt 8 lc rgb '#7f7f7f' title 'GSL msadams', \
     study('gsl_rkf45', 'spherical') using 1:2 with linespoints lw 2 pt 10 lc rgb '#8c564b' title 'GSL rkf45'
