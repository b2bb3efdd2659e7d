#!/bin/bash
# report.sh - touchstone tables --explain, --ties and --report, on a paper file of the test's own, with one small table.
. "$(dirname "$0")/common.bash"
root=$tests/../..
small_paper '( 1, "1.9", 0.0, "-", "-", 1.0 ), ( 2, "1.1", 0.5, "-", "-", 0.9 ), ( 8, "0.25", 0.5, "-", "-", 0.9 )'
export TOUCHSTONE_HOME=$work/home
tables() {
    "$BUILD/touchstone" tables "$@" >out 2>err </dev/null
    status=$?
}

tables --explain 1:8
check "--explain: it ends well" ended_with 0
check "--explain: both accounts add up to nodes x total" \
    awk '/^With -times/ { total = $9 }
         /nodes x total/ { n++; if (($4 - 2 * total)^2 > 1e-4 || ($6 - 6 * total)^2 > 1e-4) bad = 1 }
         END { exit bad || n != 2 }' out
tables --explain 1:8 -t 1
check "--explain: of tables it shows none" said 'explain only shows a row'
tables --explain 1:8
check "--explain: what is waited for is named" grep -qE '^  idle: msgwait, chunks ' out
check "--explain: lines with long names keep to the columns" \
    eval "grep -q '^  idle: msgwait, global operations ' out && [ \$(grep -E '^  (idle|system|computing): ' out | awk '{ print length }' | sort -u | wc -l) = 1 ]"
check "--explain: a line for each layer" test "$(grep -cE '^ +[0-9]+ +[04]( +[0-9.]+){7}$' out)" = 8
check "--explain: how much measuring takes" grep -qE '^With -times, .*: [0-9.]+ s \([-+][0-9.]+ %\)' out
check "nor is a small part printed as -0" test "$(grep -cE -- '-0\.0+( |$)' out)" = 0
tables --explain 1:1
check "--explain: one node has no slaves" bash -c '! grep -q slave out'
tables --explain 1:3
check "--explain: a row that is not there" ended_with 65
check "--explain: how rows are named" said 'no row 1:3 .*1:128'

tables --ties --report report.md -o made
check "--report: it ends well" ended_with 0
check "--ties: a range stands beside the row" grep -qE '^ +2 .* [0-9.]+ to [0-9.]+ s$' out
check "--ties: in the JSON too" grep -q '"tie_runs": 8' made/tables.json
check "report: every row, its rounding and standing" test "$(grep -cE '^\| [128] \|.*\| (fitted|predicted) \|' report.md)" = 3
check "report: half a unit of 1.9 s" grep -qE '^\| 1 \|.*\| 2\.63 \| \+0\.00 \| fitted' report.md
check "report: fitted and predicted runs apart" grep -qE 'predictions \| 2 \|' report.md
check "report: what was fitted" grep -qF '| cost of slice.c | x 1.5 | a slice |' report.md
check "report: a remark of paper.cfg" grep -qF 'It is like that.' report.md
check "report: where the time of a row goes" grep -qE '^\| computing \|' report.md
tables --ties --report again.md -o made
check "report: the same twice" cmp report.md again.md

printf 'before\n<!-- accuracy: x -->\nold\n<!-- accuracy ends -->\nafter\n' >readme
"$root/bench/paper/copy-accuracy" report.md readme 2>err
check "copy-accuracy: what is around stays" test "$(sed -n '1p;$p' readme | tr '\n' ' ')" = "before after "
accuracy() { sed -n '/^<!-- accuracy: /,/^<!-- accuracy ends/{/^| Table/!p}' "$1"; }
check "copy-accuracy: the README has what the report has" test "$(accuracy readme)" = "$(accuracy report.md)"
check "the README in the tree agrees with the report in the tree" \
    test "$(accuracy "$root/README.md")" = "$(accuracy "$root/bench/paper/REPORT.md")"
check "that part is not empty" test "$(accuracy "$root/README.md" | wc -l)" -gt 5
