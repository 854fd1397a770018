# Written by kyvadlo study; draws study_roots.svg and study_roots.png from study.csv.
# gnuplot study_roots.gp
if (!exists('before')) before = ''
csv = 'study.csv'
set datafile separator ','
set logscale xy
set xrange [1e1:1e6]
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
set terminal svg size 1280,870 enhanced background '#ffffff'
set output before.'study_roots.svg'
set multiplot layout 3,4 title 'Turning heights from energy and momentum; error relative to the length, or to a root beyond it; against nanoseconds a result' margins 0.0430,0.9883,0.0402,0.9253 spacing 0.0469,0.0828
set title 'typical'
plot \
   csv using (taken_by_all('roots', 'typical', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'typical', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'typical', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'typical', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'typical', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'typical', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'near\_conical'
plot \
   csv using (taken_by_all('roots', 'near_conical', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'near_conical', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'near_conical', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'near_conical', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_conical', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_conical', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'near\_plane'
plot \
   csv using (taken_by_all('roots', 'near_plane', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'near_plane', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'near_plane', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'near_plane', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_plane', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_plane', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'near\_upright'
plot \
   csv using (taken_by_all('roots', 'near_upright', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'near_upright', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'near_upright', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'near_upright', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_upright', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_upright', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'small'
plot \
   csv using (taken_by_all('roots', 'small', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'small', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'small', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'small', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'small', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'small', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'energetic'
plot \
   csv using (taken_by_all('roots', 'energetic', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'energetic', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'energetic', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'energetic', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'energetic', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'energetic', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'plane'
plot \
   csv using (taken_by_all('roots', 'plane', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'plane', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'plane', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'plane', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'plane', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'plane', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'near\_double'
plot \
   csv using (taken_by_all('roots', 'near_double', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'near_double', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'near_double', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'near_double', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_double', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_double', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'nearly\_equal'
plot \
   csv using (taken_by_all('roots', 'nearly_equal', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'nearly_equal', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'nearly_equal', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'nearly_equal', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'nearly_equal', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'nearly_equal', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
unset title
unset border
unset tics
unset grid
set key center center font ",8" samplen 2 spacing 0.8
plot \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2 title 'ours real32', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2 title 'ours real64', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2 title 'ours real128', \
   NaN with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1 title 'cardano', \
   NaN with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_cubic', \
   NaN with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1 title 'lapack\_dgeev'   
unset multiplot
set key off
set border
set tics font ",9" nomirror
set ytics 1e-35, 1e5, 1
set grid
set terminal pngcairo size 1280,870 enhanced
set output before.'study_roots.png'
set multiplot layout 3,4 title 'Turning heights from energy and momentum; error relative to the length, or to a root beyond it; against nanoseconds a result' margins 0.0430,0.9883,0.0402,0.9253 spacing 0.0469,0.0828
set title 'typical'
plot \
   csv using (taken_by_all('roots', 'typical', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'typical', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'typical', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'typical', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'typical', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'typical', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'near\_conical'
plot \
   csv using (taken_by_all('roots', 'near_conical', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'near_conical', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'near_conical', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'near_conical', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_conical', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_conical', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'near\_plane'
plot \
   csv using (taken_by_all('roots', 'near_plane', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'near_plane', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'near_plane', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'near_plane', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_plane', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_plane', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'near\_upright'
plot \
   csv using (taken_by_all('roots', 'near_upright', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'near_upright', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'near_upright', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'near_upright', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_upright', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_upright', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'small'
plot \
   csv using (taken_by_all('roots', 'small', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'small', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'small', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'small', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'small', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'small', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'energetic'
plot \
   csv using (taken_by_all('roots', 'energetic', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'energetic', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'energetic', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'energetic', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'energetic', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'energetic', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'plane'
plot \
   csv using (taken_by_all('roots', 'plane', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'plane', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'plane', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'plane', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'plane', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'plane', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'near\_double'
plot \
   csv using (taken_by_all('roots', 'near_double', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'near_double', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'near_double', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'near_double', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_double', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'near_double', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
set title 'nearly\_equal'
plot \
   csv using (taken_by_all('roots', 'nearly_equal', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('roots', 'nearly_equal', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('roots', 'nearly_equal', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('roots', 'nearly_equal', 'cardano', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'nearly_equal', 'gsl_cubic', 'real64')):(@error) with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('roots', 'nearly_equal', 'lapack_dgeev', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1   
unset title
unset border
unset tics
unset grid
set key center center font ",8" samplen 2 spacing 0.8
plot \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2 title 'ours real32', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2 title 'ours real64', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2 title 'ours real128', \
   NaN with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1 title 'cardano', \
   NaN with points      lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_cubic', \
   NaN with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1 title 'lapack\_dgeev'   
unset multiplot
set key off
set border
set tics font ",9" nomirror
set ytics 1e-35, 1e5, 1
set grid
