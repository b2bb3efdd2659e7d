#!/bin/bash
# tables.sh - touchstone tables from end to end: prints a table's figures, equal in two runs.
. "$(dirname "$0")/common.bash"

"$BUILD/touchstone" tables -t 2,98 -t 1 -o first --json - >json 2>out # the last -t counts
status=$?
check "it ends well" ended_with 0
check "--json -: JSON alone, that of tables.json" cmp json first/tables.json
check "every row stands beside the paper's" test "$(grep -cE '^ +[0-9]+ +[0-9.]+ +[0-9.]+ +[-+]?[0-9.]+ %' out)" = 8
check "an error of nothing has no sign" bash -c '! grep -qE "[-+]0\.0 %" out'
# Of a line: where its words end; the sign and the unit of an error belong to its word.
ends() { sed 's/ %/_%/' | awk '{ while (match(substr($0, at + 1), /[^ ]+/)) { at += RSTART + RLENGTH - 1; printf "%d ", at } }'; }
check "each column ends where its head ends" test "$(grep '^ *nodes .*simulated' out | ends)" = "$(grep -m 1 '^ *2 ' out | ends)"
check "the mean error is given" grep -qE 'mean error [0-9.]+ %, worst' out
for f in tables.json table-1.png table-1.svg; do check "$f is there" test -s first/$f; done

# Killed when some rows are there, it goes on from them; once all are there, the next one begins anew. So all rows have run twice.
"$BUILD/touchstone" tables -t 1 -o again -j 2 >out 2>err &
has_two() { [ "$(cat again/journal 2>/dev/null | grep -c ' d {')" -ge 2 ]; }
awaited has_two
kill -9 $!
wait $! 2>/dev/null
"$BUILD/touchstone" tables -t 1 -o again -j 2 >out 2>err &
awaited pgrep -P $! >children
kill -TERM $!
wait $! 2>/dev/null
check "stopped by SIGTERM, it ends with 143" test $? = 143
check "says so, and calls no run failed" bash -c '! grep -q killed out err && grep -q "stopped; the same command goes on" err'
# In place of gnuplot: keeps the script.
mkdir bin
printf '#!/bin/sh\ncp "$1" %s/plot\n' "$work" >bin/gnuplot
chmod +x bin/gnuplot
PATH=$work/bin:$PATH "$BUILD/touchstone" tables -t 1 -o again >out 2>err
status=$?
check "after kill -9 it goes on" bash -c '[ "$1" = 0 ] && grep -qE "^[2-8] of 8 runs are in again/journal" err' - $status
grep -v wall_time first/tables.json >a
grep -v wall_time again/tables.json >b
check "all but wall times is the same twice" cmp a b
check "and nothing is kept when all is there" test ! -e again/journal

# Of each row: nodes and the error as printed; and as drawn below the times, for which 0 is no residual.
printed() { sed -nE 's/^ +([0-9]+) +[0-9.]+ +[0-9.]+ +([-+][0-9.]+) %.*/\1 \2/p' out; }
drawn() { sed -n '/^\$data/,/^END/p' plot | awk 'NF == 9 { printf "%d %+.1f\n", $1, $6 }'; }
check "each row's residual is drawn" bash -c '[ "$1" = "$2" ] && [ $(wc -l <<<"$1") = 8 ]' - "$(drawn)" "$(printed)"
check "the speed-up's residual is that of T(1) / T(N)" awk '$1 == "$data" { on = 1; next } $1 == "END" { on = 0 }
    on && ($7 - 100 * ($4 / $5 - 1)) ^ 2 > 1e-10 { bad = 1 } on { n++ } END { exit bad || n != 8 }' plot
check "text and picture have one word for what was simulated" \
    bash -c 'grep -q "^ *nodes *simulated *paper" out && grep -q "title .simulated.*title .paper" plot'
check "the legend has fitted rows, and no predicted ones, as Table 1" bash -c 'grep -q "title .fitted" plot && ! grep -q predicted plot'
check "in a panel with a line at 0" test "$(grep -c '^plot 0 with lines .*using 1:6' plot)" = 2
