# Written by kyvadlo study; draws study_period.svg and study_period.png from study.csv.
# gnuplot study_period.gp
if (!exists('before')) before = ''
csv = 'study.csv'
set datafile separator ','
set logscale xy
set xrange [1e0:1e6]
set yrange [1e-37:10]
set ytics 1e-35, 1e5, 1
set format '10^{%L}'
set grid
set tics font ",9" nomirror
set key off
set title font ",11" offset 0,-0.7
is(q, o, m, k) = strcol(1) eq q && strcol(2) eq o && strcol(3) eq m && strcol(5) eq k
taken(q, o, m, k, f) = is(q, o, m, k) && strstrt(strcol(4), f) > 0 ? column(7) : NaN
taken_by_all(q, o, m, k) = is(q, o, m, k) ? column(7) : NaN
error = '(column(6) > 1e-36 ? column(6) < 10 ? column(6) : 10 : 1e-36)'
set terminal svg size 1280,600 enhanced background '#ffffff'
set output before.'study_period.svg'
set multiplot layout 2,4 title 'Period; relative error; against nanoseconds a result' margins 0.0430,0.9883,0.0583,0.8917 spacing 0.0469,0.1200
set title 'typical'
plot \
   csv using (taken_by_all('period', 'typical', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'typical', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'typical', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'typical', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'typical', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'typical', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'typical', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'typical', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'typical', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'typical', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'typical', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'typical', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'typical', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
set title 'near\_conical'
plot \
   csv using (taken_by_all('period', 'near_conical', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'near_conical', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'near_conical', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'near_conical', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'near_conical', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'near_conical', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_conical', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_conical', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_conical', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_conical', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'near_conical', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'near_conical', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'near_conical', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
set title 'near\_plane'
plot \
   csv using (taken_by_all('period', 'near_plane', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'near_plane', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'near_plane', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'near_plane', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'near_plane', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'near_plane', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_plane', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_plane', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_plane', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_plane', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'near_plane', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'near_plane', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'near_plane', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
set title 'near\_upright'
plot \
   csv using (taken_by_all('period', 'near_upright', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'near_upright', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'near_upright', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'near_upright', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'near_upright', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'near_upright', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_upright', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_upright', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_upright', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_upright', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'near_upright', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'near_upright', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'near_upright', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
set title 'small'
plot \
   csv using (taken_by_all('period', 'small', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'small', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'small', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'small', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'small', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'small', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'small', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'small', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'small', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'small', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'small', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'small', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'small', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
set title 'energetic'
plot \
   csv using (taken_by_all('period', 'energetic', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'energetic', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'energetic', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'energetic', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'energetic', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'energetic', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'energetic', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'energetic', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'energetic', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'energetic', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'energetic', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'energetic', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'energetic', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
set title 'plane'
plot \
   csv using (taken_by_all('period', 'plane', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'plane', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'plane', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'plane', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'plane', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'plane', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'plane', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'plane', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'plane', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'plane', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'plane', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'plane', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'plane', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
unset title
unset border
unset tics
unset grid
set key center center font ",8" samplen 2 spacing 0.8
plot \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2 title 'closed\_form real32', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2 title 'closed\_form real64', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2 title 'closed\_form real128', \
   NaN with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2 title 'closed\_form accuracy real64', \
   NaN with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2 title 'closed\_form accuracy real128', \
   NaN with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1 title 'agm\_terms', \
   NaN with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1 title 'carlson\_early', \
   NaN with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_ellint', \
   NaN with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1 title 'gauss\_legendre', \
   NaN with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_qag', \
   NaN with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1 title 'series ellipse', \
   NaN with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1 title 'series amplitude', \
   NaN with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1 title 'series sine'   
unset multiplot
set key off
set border
set tics font ",9" nomirror
set ytics 1e-35, 1e5, 1
set grid
set terminal pngcairo size 1280,600 enhanced
set output before.'study_period.png'
set multiplot layout 2,4 title 'Period; relative error; against nanoseconds a result' margins 0.0430,0.9883,0.0583,0.8917 spacing 0.0469,0.1200
set title 'typical'
plot \
   csv using (taken_by_all('period', 'typical', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'typical', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'typical', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'typical', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'typical', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'typical', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'typical', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'typical', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'typical', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'typical', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'typical', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'typical', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'typical', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
set title 'near\_conical'
plot \
   csv using (taken_by_all('period', 'near_conical', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'near_conical', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'near_conical', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'near_conical', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'near_conical', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'near_conical', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_conical', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_conical', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_conical', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_conical', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'near_conical', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'near_conical', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'near_conical', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
set title 'near\_plane'
plot \
   csv using (taken_by_all('period', 'near_plane', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'near_plane', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'near_plane', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'near_plane', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'near_plane', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'near_plane', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_plane', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_plane', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_plane', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_plane', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'near_plane', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'near_plane', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'near_plane', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
set title 'near\_upright'
plot \
   csv using (taken_by_all('period', 'near_upright', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'near_upright', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'near_upright', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'near_upright', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'near_upright', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'near_upright', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_upright', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_upright', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_upright', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'near_upright', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'near_upright', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'near_upright', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'near_upright', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
set title 'small'
plot \
   csv using (taken_by_all('period', 'small', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'small', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'small', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'small', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'small', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'small', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'small', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'small', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'small', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'small', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'small', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'small', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'small', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
set title 'energetic'
plot \
   csv using (taken_by_all('period', 'energetic', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'energetic', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'energetic', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'energetic', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'energetic', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'energetic', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'energetic', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'energetic', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'energetic', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'energetic', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'energetic', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'energetic', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'energetic', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
set title 'plane'
plot \
   csv using (taken_by_all('period', 'plane', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('period', 'plane', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('period', 'plane', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('period', 'plane', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('period', 'plane', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('period', 'plane', 'agm_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'plane', 'carlson_early', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'plane', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'plane', 'gauss_legendre', 'real64')):(@error) with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('period', 'plane', 'gsl_qag', 'real64')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'plane', 'series', 'real64', 'ellipse')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('period', 'plane', 'series', 'real64', 'amplitude')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('period', 'plane', 'series', 'real64', 'sine')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1   
unset title
unset border
unset tics
unset grid
set key center center font ",8" samplen 2 spacing 0.8
plot \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2 title 'closed\_form real32', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2 title 'closed\_form real64', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2 title 'closed\_form real128', \
   NaN with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2 title 'closed\_form accuracy real64', \
   NaN with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2 title 'closed\_form accuracy real128', \
   NaN with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1 title 'agm\_terms', \
   NaN with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1 title 'carlson\_early', \
   NaN with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_ellint', \
   NaN with linespoints lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1 title 'gauss\_legendre', \
   NaN with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_qag', \
   NaN with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1 title 'series ellipse', \
   NaN with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1 title 'series amplitude', \
   NaN with linespoints lc rgb '#8c564b' ps 0.6 dt 3 pt 7 lw 1 title 'series sine'   
unset multiplot
set key off
set border
set tics font ",9" nomirror
set ytics 1e-35, 1e5, 1
set grid
