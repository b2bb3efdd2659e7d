# pictures.gp - what `make validate` measured, as pictures in out/validate/. Called in that folder.
set terminal svg size 760,520 font 'Sans,12' background rgb 'white'
set grid lc rgb '#d8d8d8'
set border 3
set tics nomirror
set key top left

short(n, d) = 65 + 0.425 * n + 10.0 * d
long(n, d) = 147 + 0.390 * n + 30.5 * d

set output 'echo.svg'
set title 'Echo test, iPSC/860: points simulated, lines Bokhari'
set xlabel 'bytes'
set ylabel 'microseconds, one way'
set logscale xy
set xrange [1:2e6]
plot for [d in "1 4 7"] 'ipsc860-echo.echo.dat' using ($1 < 1 ? NaN : $2 == d ? $1 : NaN):3 \
         with points pt 7 ps 0.6 title d.' hops', \
     for [d in "1 4 7"] (x <= 100 ? short(x, d) : long(x, d)) with lines lw 1 lc rgb '#606060' notitle

set output 'speed.svg'
set title 'Speed over length'
set ylabel 'MB/s'
plot 'ipsc860-echo.echo.dat' using ($2 == 1 ? $1 : NaN):($1 / $3) with linespoints pt 7 ps 0.5 title 'iPSC/860', \
     'delta-echo.echo.dat' using 1:($1 / $3) with linespoints pt 7 ps 0.5 title 'Delta, receive posted', \
     'delta-echo-late.echo.dat' using 1:($1 / $3) with linespoints pt 6 ps 0.5 title 'Delta, not posted', \
     'paragon-echo.echo.dat' using 1:($1 / $3) with linespoints pt 7 ps 0.5 title 'Paragon 1994', \
     'paragon95-echo.echo.dat' using 1:($1 / $3) with linespoints pt 7 ps 0.5 title 'Paragon 1995'

set output 'global.svg'
set key bottom right
set title 'Operations of all nodes'
set xlabel 'nodes'
set ylabel 'microseconds'
set xrange [1.5:700]
set logscale x 2
plot for [m in "ipsc860 delta paragon"] m.'-global.gsync.dat' using 1:3 with linespoints pt 7 ps 0.5 title m.' gsync', \
     for [m in "ipsc860 delta paragon"] m.'-global.broadcast_1024.dat' using 1:3 with linespoints pt 6 ps 0.6 \
         title m.' broadcast of 1 KB'

set output 'complete.svg'
set key top left
set title 'Complete exchange, 32 nodes of an iPSC/860'
set xlabel 'bytes a block'
set xrange [3:1500]
set logscale x 10
plot 'ipsc860-complete.direct_32.dat' using 1:3 with linespoints pt 7 ps 0.5 title 'direct', \
     'ipsc860-complete.standard_32.dat' using 1:3 with linespoints pt 6 ps 0.6 title 'standard'
