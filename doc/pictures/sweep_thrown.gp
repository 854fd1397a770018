# How probably a string goes slack when the ball is hit from below, over the speed, from a sweep of throws whose speed across is
# uncertain. The line is the probability by the law 2 g l < v**2 < 5 g l.
set terminal svg size 640,420 fixed font 'sans-serif,13' background 'white'
set datafile separator ','
set xlabel 'speed along [m/s]'
set ylabel 'probability of a slack string'
set yrange [0:1.05]
set key bottom center
set grid
set samples 500
throws = "< kyvadlo sweep examples/sweeps/thrown.nml | awk -F, 'NR > 1 { n[$1]++; s[$1] += $3 != \"\" } END { for (v in n) print v \",\" s[v]/n[v] }' | sort -g"
inside(v, w2) = w2 > v*v ? erf(sqrt((w2 - v*v)/2)) : 0
plot throws using 1:2 with points pt 7 ps 0.6 title '100 throws', \
     [2:9] inside(x, 5*9.80665) - inside(x, 2*9.80665) with lines lw 2 title 'law'
