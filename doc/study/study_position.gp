# Written by kyvadlo study; draws study_position.svg and study_position.png from study.csv.
# gnuplot study_position.gp
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
set output before.'study_position.svg'
set multiplot layout 2,4 title 'Position at times within one period; error relative to the length; against nanoseconds a result' margins 0.0430,0.9883,0.0583,0.8917 spacing 0.0469,0.1200
set title 'typical'
plot \
   csv using (taken_by_all('position', 'typical', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'typical', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'typical', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'typical', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'typical', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'typical', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'typical', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'typical', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'typical', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'typical', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'typical', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
set title 'near\_conical'
plot \
   csv using (taken_by_all('position', 'near_conical', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'near_conical', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'near_conical', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'near_conical', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'near_conical', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'near_conical', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'near_conical', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_conical', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'near_conical', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_conical', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_conical', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
set title 'near\_plane'
plot \
   csv using (taken_by_all('position', 'near_plane', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'near_plane', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'near_plane', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'near_plane', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'near_plane', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'near_plane', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'near_plane', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_plane', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'near_plane', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_plane', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_plane', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
set title 'near\_upright'
plot \
   csv using (taken_by_all('position', 'near_upright', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'near_upright', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'near_upright', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'near_upright', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'near_upright', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'near_upright', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'near_upright', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_upright', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'near_upright', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_upright', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_upright', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
set title 'small'
plot \
   csv using (taken_by_all('position', 'small', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'small', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'small', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'small', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'small', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'small', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'small', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'small', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'small', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'small', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'small', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
set title 'energetic'
plot \
   csv using (taken_by_all('position', 'energetic', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'energetic', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'energetic', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'energetic', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'energetic', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'energetic', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'energetic', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'energetic', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'energetic', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'energetic', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'energetic', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
set title 'plane'
plot \
   csv using (taken_by_all('position', 'plane', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'plane', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'plane', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'plane', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'plane', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'plane', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'plane', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'plane', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'plane', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'plane', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'plane', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
unset title
unset border
unset tics
unset grid
set key center center font ",8" samplen 2 spacing 0.8
plot \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2 title 'closed\_form real32', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2 title 'closed\_form real64', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2 title 'closed\_form real128', \
   NaN with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2 title 'closed\_form accuracy real32', \
   NaN with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2 title 'closed\_form accuracy real64', \
   NaN with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2 title 'closed\_form accuracy real128', \
   NaN with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1 title 'theta\_terms real64', \
   NaN with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1 title 'theta\_terms real128', \
   NaN with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1 title 'jacobi\_series', \
   NaN with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1 title 'carlson\_point', \
   NaN with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1 title 'small\_angle', \
   NaN with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_rk4 cartesian', \
   NaN with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1 title 'gsl\_rk4 spherical', \
   NaN with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_rkf45 cartesian', \
   NaN with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1 title 'gsl\_rkf45 spherical', \
   NaN with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_rk8pd cartesian', \
   NaN with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1 title 'gsl\_rk8pd spherical', \
   NaN with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_msadams cartesian', \
   NaN with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1 title 'gsl\_msadams spherical', \
   NaN with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_bsimp cartesian', \
   NaN with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1 title 'gsl\_bsimp spherical'   
unset multiplot
set key off
set border
set tics font ",9" nomirror
set ytics 1e-35, 1e5, 1
set grid
set terminal pngcairo size 1280,600 enhanced
set output before.'study_position.png'
set multiplot layout 2,4 title 'Position at times within one period; error relative to the length; against nanoseconds a result' margins 0.0430,0.9883,0.0583,0.8917 spacing 0.0469,0.1200
set title 'typical'
plot \
   csv using (taken_by_all('position', 'typical', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'typical', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'typical', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'typical', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'typical', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'typical', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'typical', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'typical', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'typical', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'typical', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'typical', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'typical', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
set title 'near\_conical'
plot \
   csv using (taken_by_all('position', 'near_conical', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'near_conical', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'near_conical', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'near_conical', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'near_conical', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'near_conical', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'near_conical', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_conical', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'near_conical', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_conical', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_conical', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_conical', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
set title 'near\_plane'
plot \
   csv using (taken_by_all('position', 'near_plane', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'near_plane', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'near_plane', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'near_plane', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'near_plane', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'near_plane', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'near_plane', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_plane', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'near_plane', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_plane', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_plane', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_plane', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
set title 'near\_upright'
plot \
   csv using (taken_by_all('position', 'near_upright', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'near_upright', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'near_upright', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'near_upright', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'near_upright', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'near_upright', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'near_upright', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_upright', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'near_upright', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_upright', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'near_upright', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'near_upright', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
set title 'small'
plot \
   csv using (taken_by_all('position', 'small', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'small', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'small', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'small', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'small', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'small', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'small', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'small', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'small', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'small', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'small', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'small', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
set title 'energetic'
plot \
   csv using (taken_by_all('position', 'energetic', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'energetic', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'energetic', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'energetic', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'energetic', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'energetic', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'energetic', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'energetic', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'energetic', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'energetic', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'energetic', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'energetic', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
set title 'plane'
plot \
   csv using (taken_by_all('position', 'plane', 'closed_form', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('position', 'plane', 'closed_form', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('position', 'plane', 'closed_form', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken('position', 'plane', 'closed_form', 'real32', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2, \
   csv using (taken('position', 'plane', 'closed_form', 'real64', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2, \
   csv using (taken('position', 'plane', 'closed_form', 'real128', 'accuracy')):(@error) with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2, \
   csv using (taken_by_all('position', 'plane', 'theta_terms', 'real64')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'plane', 'theta_terms', 'real128')):(@error) with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1, \
   csv using (taken_by_all('position', 'plane', 'jacobi_series', 'real64')):(@error) with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'plane', 'carlson_point', 'real64')):(@error) with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken_by_all('position', 'plane', 'small_angle', 'real64')):(@error) with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_rk4', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_rk4', 'real64', 'spherical')):(@error) with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_rkf45', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_rkf45', 'real64', 'spherical')):(@error) with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_rk8pd', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_rk8pd', 'real64', 'spherical')):(@error) with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_msadams', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_msadams', 'real64', 'spherical')):(@error) with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_bsimp', 'real64', 'cartesian')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1, \
   csv using (taken('position', 'plane', 'gsl_bsimp', 'real64', 'spherical')):(@error) with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1   
unset title
unset border
unset tics
unset grid
set key center center font ",8" samplen 2 spacing 0.8
plot \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2 title 'closed\_form real32', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2 title 'closed\_form real64', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2 title 'closed\_form real128', \
   NaN with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 6 lw 2 title 'closed\_form accuracy real32', \
   NaN with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 7 lw 2 title 'closed\_form accuracy real64', \
   NaN with linespoints lc rgb '#d62728' ps 0.6 dt 2 pt 9 lw 2 title 'closed\_form accuracy real128', \
   NaN with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1 title 'theta\_terms real64', \
   NaN with linespoints lc rgb '#1f77b4' ps 0.6 dt 1 pt 9 lw 1 title 'theta\_terms real128', \
   NaN with linespoints lc rgb '#2ca02c' ps 0.6 dt 1 pt 7 lw 1 title 'jacobi\_series', \
   NaN with points      lc rgb '#9467bd' ps 0.6 dt 1 pt 7 lw 1 title 'carlson\_point', \
   NaN with points      lc rgb '#ff7f0e' ps 0.6 dt 1 pt 7 lw 1 title 'small\_angle', \
   NaN with linespoints lc rgb '#17becf' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_rk4 cartesian', \
   NaN with linespoints lc rgb '#17becf' ps 0.6 dt 2 pt 7 lw 1 title 'gsl\_rk4 spherical', \
   NaN with linespoints lc rgb '#8c564b' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_rkf45 cartesian', \
   NaN with linespoints lc rgb '#8c564b' ps 0.6 dt 2 pt 7 lw 1 title 'gsl\_rkf45 spherical', \
   NaN with linespoints lc rgb '#e377c2' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_rk8pd cartesian', \
   NaN with linespoints lc rgb '#e377c2' ps 0.6 dt 2 pt 7 lw 1 title 'gsl\_rk8pd spherical', \
   NaN with linespoints lc rgb '#7f7f7f' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_msadams cartesian', \
   NaN with linespoints lc rgb '#7f7f7f' ps 0.6 dt 2 pt 7 lw 1 title 'gsl\_msadams spherical', \
   NaN with linespoints lc rgb '#bcbd22' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_bsimp cartesian', \
   NaN with linespoints lc rgb '#bcbd22' ps 0.6 dt 2 pt 7 lw 1 title 'gsl\_bsimp spherical'   
unset multiplot
set key off
set border
set tics font ",9" nomirror
set ytics 1e-35, 1e5, 1
set grid
