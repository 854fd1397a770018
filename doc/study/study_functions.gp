# Written by kyvadlo study; draws study_functions.svg and study_functions.png from study.csv.
# gnuplot study_functions.gp
if (!exists('before')) before = ''
csv = 'study.csv'
set datafile separator ','
set logscale xy
set xrange [1e0:1e5]
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
set terminal svg size 2240,1140 enhanced background '#ffffff'
set output before.'study_functions.svg'
set multiplot layout 4,7 title 'Elliptic functions; relative error, of sn, cn, dn absolute; against nanoseconds a result' margins 0.0246,0.9933,0.0307,0.9430 spacing 0.0268,0.0632
set title 'R\_C'
plot \
   csv using (taken_by_all('functions', 'R_C', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_C', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_C', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_C', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_F'
plot \
   csv using (taken_by_all('functions', 'R_F', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_F', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_F', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_F', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_D'
plot \
   csv using (taken_by_all('functions', 'R_D', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_D', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_D', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_D', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_J'
plot \
   csv using (taken_by_all('functions', 'R_J', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_J', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_J', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_J', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'K'
plot \
   csv using (taken_by_all('functions', 'K', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'K', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'K', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'K', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'E'
plot \
   csv using (taken_by_all('functions', 'E', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'E', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'E', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'E', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'D'
plot \
   csv using (taken_by_all('functions', 'D', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'D', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'D', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'D', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'Pi'
plot \
   csv using (taken_by_all('functions', 'Pi', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'Pi', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'Pi', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'Pi', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'F(phi)'
plot \
   csv using (taken_by_all('functions', 'F(phi)', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'F(phi)', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'F(phi)', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'F(phi)', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'E(phi)'
plot \
   csv using (taken_by_all('functions', 'E(phi)', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'E(phi)', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'E(phi)', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'E(phi)', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'D(phi)'
plot \
   csv using (taken_by_all('functions', 'D(phi)', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'D(phi)', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'D(phi)', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'D(phi)', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'Pi(phi)'
plot \
   csv using (taken_by_all('functions', 'Pi(phi)', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'Pi(phi)', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'Pi(phi)', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'Pi(phi)', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'sn cn dn'
plot \
   csv using (taken_by_all('functions', 'sn cn dn', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'sn cn dn', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'sn cn dn', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'sn cn dn', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_C hard'
plot \
   csv using (taken_by_all('functions', 'R_C hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_C hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_C hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_C hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_F hard'
plot \
   csv using (taken_by_all('functions', 'R_F hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_F hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_F hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_F hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_D hard'
plot \
   csv using (taken_by_all('functions', 'R_D hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_D hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_D hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_D hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_J hard'
plot \
   csv using (taken_by_all('functions', 'R_J hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_J hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_J hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_J hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'K hard'
plot \
   csv using (taken_by_all('functions', 'K hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'K hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'K hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'K hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'E hard'
plot \
   csv using (taken_by_all('functions', 'E hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'E hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'E hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'E hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'D hard'
plot \
   csv using (taken_by_all('functions', 'D hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'D hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'D hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'D hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'Pi hard'
plot \
   csv using (taken_by_all('functions', 'Pi hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'Pi hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'Pi hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'Pi hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'F(phi) hard'
plot \
   csv using (taken_by_all('functions', 'F(phi) hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'F(phi) hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'F(phi) hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'F(phi) hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'E(phi) hard'
plot \
   csv using (taken_by_all('functions', 'E(phi) hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'E(phi) hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'E(phi) hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'E(phi) hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'D(phi) hard'
plot \
   csv using (taken_by_all('functions', 'D(phi) hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'D(phi) hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'D(phi) hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'D(phi) hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'Pi(phi) hard'
plot \
   csv using (taken_by_all('functions', 'Pi(phi) hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'Pi(phi) hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'Pi(phi) hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'Pi(phi) hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'sn cn dn hard'
plot \
   csv using (taken_by_all('functions', 'sn cn dn hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'sn cn dn hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'sn cn dn hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'sn cn dn hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
unset title
unset border
unset tics
unset grid
set key center center font ",8" samplen 2 spacing 0.8
plot \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2 title 'ours real32', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2 title 'ours real64', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2 title 'ours real128', \
   NaN with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_ellint'   
unset multiplot
set key off
set border
set tics font ",9" nomirror
set ytics 1e-35, 1e5, 1
set grid
set terminal pngcairo size 2240,1140 enhanced
set output before.'study_functions.png'
set multiplot layout 4,7 title 'Elliptic functions; relative error, of sn, cn, dn absolute; against nanoseconds a result' margins 0.0246,0.9933,0.0307,0.9430 spacing 0.0268,0.0632
set title 'R\_C'
plot \
   csv using (taken_by_all('functions', 'R_C', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_C', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_C', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_C', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_F'
plot \
   csv using (taken_by_all('functions', 'R_F', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_F', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_F', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_F', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_D'
plot \
   csv using (taken_by_all('functions', 'R_D', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_D', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_D', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_D', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_J'
plot \
   csv using (taken_by_all('functions', 'R_J', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_J', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_J', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_J', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'K'
plot \
   csv using (taken_by_all('functions', 'K', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'K', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'K', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'K', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'E'
plot \
   csv using (taken_by_all('functions', 'E', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'E', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'E', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'E', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'D'
plot \
   csv using (taken_by_all('functions', 'D', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'D', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'D', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'D', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'Pi'
plot \
   csv using (taken_by_all('functions', 'Pi', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'Pi', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'Pi', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'Pi', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'F(phi)'
plot \
   csv using (taken_by_all('functions', 'F(phi)', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'F(phi)', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'F(phi)', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'F(phi)', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'E(phi)'
plot \
   csv using (taken_by_all('functions', 'E(phi)', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'E(phi)', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'E(phi)', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'E(phi)', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'D(phi)'
plot \
   csv using (taken_by_all('functions', 'D(phi)', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'D(phi)', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'D(phi)', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'D(phi)', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'Pi(phi)'
plot \
   csv using (taken_by_all('functions', 'Pi(phi)', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'Pi(phi)', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'Pi(phi)', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'Pi(phi)', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'sn cn dn'
plot \
   csv using (taken_by_all('functions', 'sn cn dn', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'sn cn dn', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'sn cn dn', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'sn cn dn', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_C hard'
plot \
   csv using (taken_by_all('functions', 'R_C hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_C hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_C hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_C hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_F hard'
plot \
   csv using (taken_by_all('functions', 'R_F hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_F hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_F hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_F hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_D hard'
plot \
   csv using (taken_by_all('functions', 'R_D hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_D hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_D hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_D hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'R\_J hard'
plot \
   csv using (taken_by_all('functions', 'R_J hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'R_J hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'R_J hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'R_J hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'K hard'
plot \
   csv using (taken_by_all('functions', 'K hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'K hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'K hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'K hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'E hard'
plot \
   csv using (taken_by_all('functions', 'E hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'E hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'E hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'E hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'D hard'
plot \
   csv using (taken_by_all('functions', 'D hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'D hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'D hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'D hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'Pi hard'
plot \
   csv using (taken_by_all('functions', 'Pi hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'Pi hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'Pi hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'Pi hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'F(phi) hard'
plot \
   csv using (taken_by_all('functions', 'F(phi) hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'F(phi) hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'F(phi) hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'F(phi) hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'E(phi) hard'
plot \
   csv using (taken_by_all('functions', 'E(phi) hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'E(phi) hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'E(phi) hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'E(phi) hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'D(phi) hard'
plot \
   csv using (taken_by_all('functions', 'D(phi) hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'D(phi) hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'D(phi) hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'D(phi) hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'Pi(phi) hard'
plot \
   csv using (taken_by_all('functions', 'Pi(phi) hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'Pi(phi) hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'Pi(phi) hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'Pi(phi) hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
set title 'sn cn dn hard'
plot \
   csv using (taken_by_all('functions', 'sn cn dn hard', 'ours', 'real32')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2, \
   csv using (taken_by_all('functions', 'sn cn dn hard', 'ours', 'real64')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2, \
   csv using (taken_by_all('functions', 'sn cn dn hard', 'ours', 'real128')):(@error) with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2, \
   csv using (taken_by_all('functions', 'sn cn dn hard', 'gsl_ellint', 'real64')):(@error) with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1   
unset title
unset border
unset tics
unset grid
set key center center font ",8" samplen 2 spacing 0.8
plot \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 6 lw 2 title 'ours real32', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 7 lw 2 title 'ours real64', \
   NaN with points      lc rgb '#d62728' ps 0.6 dt 1 pt 9 lw 2 title 'ours real128', \
   NaN with points      lc rgb '#1f77b4' ps 0.6 dt 1 pt 7 lw 1 title 'gsl\_ellint'   
unset multiplot
set key off
set border
set tics font ",9" nomirror
set ytics 1e-35, 1e5, 1
set grid
