#!/bin/bash
# tables.sh - touchstone tables from end to end: prints a table's figures, equal in two runs.
. "$(dirname "$0")/common.bash"

"$BUILD/touchstone" tables -t 1 -o first >out 2>err
status=$?
check "it ends well" ended_with 0
check "every row stands beside the paper's" test "$(grep -cE '^ +[0-9]+ +[0-9.]+ +[0-9.]+ +[-+][0-9.]+ %' out)" = 8
check "the mean error is given" grep -qE 'mean error [0-9.]+ %, worst' out
for f in tables.json table-1.png table-1.svg; do check "$f is there" test -s first/$f; done
"$BUILD/touchstone" tables -t 1 -o again >out 2>err
grep -v wall_time first/tables.json >a
grep -v wall_time again/tables.json >b
check "all but wall times is the same twice" cmp a b

# Killed when some rows are there, it goes on from them; once all are there, the next one begins anew.
"$BUILD/touchstone" tables -t 1 -o killed -j 2 >out 2>err &
for ((i = 0; i < 3000; i++)); do
    [ "$(cat killed/journal 2>/dev/null | grep -c ' d {')" -ge 2 ] && break
    sleep 0.02
done
kill -9 $!
wait $! 2>/dev/null
"$BUILD/touchstone" tables -t 1 -o killed >out 2>err
status=$?
check "after kill -9 it goes on" bash -c '[ "$1" = 0 ] && grep -qE "^[2-8] of 8 runs are in killed/journal" err' - $status
check "with the same result" cmp a <(grep -v wall_time killed/tables.json)
check "and keeps nothing when all is there" test ! -e killed/journal
