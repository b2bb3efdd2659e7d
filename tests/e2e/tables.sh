#!/bin/bash
# tables.sh - touchstone tables from end to end: a table's figures are there and are the same twice.
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
