#!/bin/bash
# trace.sh - touchstone run --trace: the trace changes nothing of the run, has what the run's own figures have, is the same for
# all engines and workers, and can be cut to an interval and to nodes. (make prove compares traces of random programs.)
. "$(dirname "$0")/common.bash"
compile ring talk
compile crash_while_receiving

# The figures that a trace must not change.
figures() { grep -v -e wall_time -e start_s "$1"; }

traced() { # NAME ARGS...
    local name=$1
    shift
    "$BUILD/touchstone" run -q --json plain.json "$@" >plain.out 2>&1
    "$BUILD/touchstone" run -q --json traced.json --trace t.trace "$@" >traced.out 2>&1
    check "$name: the output with a trace" cmp plain.out traced.out
    check "$name: the figures with a trace" cmp <(figures plain.json) <(figures traced.json)
    "$BUILD/touchstone" trace info t.trace >info
    local digest
    digest=$(sed -n 's/.*"digest": "\(.*\)".*/\1/p' plain.json)
    check "$name: the trace's digest" grep -q "^digest  *$digest\$" info
    check "$name: the trace's messages" grep -q "^messages  *$(sed -n 's/.*"messages": \([0-9]*\).*/\1/p' plain.json | head -1)," info
    grep -v '/touchstone run' info >first
    local way
    for way in "-w 1" "-w 3 --shuffle 7" "--engine reference"; do
        # shellcheck disable=SC2086
        "$BUILD/touchstone" run -q $way --trace other.trace "$@" >/dev/null 2>&1
        "$BUILD/touchstone" trace info other.trace | grep -v '/touchstone run' >other
        check "$name: the same trace with $way" cmp first other
    done
}
traced "ring" -m ipsc860 -n 8 ring
traced "the model program" -m delta -n 8 "$BUILD/app/model" -sphere 32 32 9 -group 4

# The first program of traced() whose nodes end at different times is the model: its states are shares of all nodes' time.
"$BUILD/touchstone" trace info --json states.json t.trace
check "trace info: the share of the nodes' time in which they compute" grep -qx \
    "computing *$(jq -r '.states_ps.computing / .nodes / .end_ps * 1000 | round | "\(. / 10 | floor).\(. % 10)"' states.json) % of the nodes' time" info
check "trace info: and in which they have ended" grep -q '^ended  *[0-9.]* % of' info

# A crash: what other nodes' programs have done ahead of it did not happen, nor what they learned in a call.
calls() { # N ARGS...
    local n=$1
    shift
    "$BUILD/touchstone" run -q -m ipsc860 -n 4 --trace c.trace "$@" crash_while_receiving "$n" >/dev/null 2>&1
    "$BUILD/touchstone" trace export -f csv --table calls c.trace
}
for n in 0 49 56 63 70 77 84; do
    calls $n --engine reference >first
    calls $n -w 3 >other
    check "a crash at $n: the calls of the trace" cmp first other
done
check "the last crash came in a receive" grep -q '^.*,node 0,.*,,crecv,' first

# A part of it.
"$BUILD/touchstone" run -q -m ipsc860 -n 8 --trace part.trace --trace-from 10ms --trace-to 20ms --trace-nodes 2-3,5 ring >/dev/null 2>&1
"$BUILD/touchstone" trace info part.trace >info
check "--trace-from, --trace-to" grep -q '^time  *10 ms to 20 ms of 39\.4' info
"$BUILD/touchstone" run -q -m ipsc860 -n 8 --trace all.trace ring >/dev/null 2>&1
"$BUILD/touchstone" trace info --from 10ms --to 20ms --nodes 2-3,5 all.trace | sed 1d >selected
check "a part that was traced is the part of a whole trace" cmp selected <(sed 1d info)

# What a killed run leaves.
"$BUILD/nxcc" -O2 -o endless "$tests/endless.c"
"$BUILD/touchstone" run -q -n 2 --trace hit.trace --record hit.schedule endless >/dev/null 2>&1 &
both_begun() { [ "$(ls -d hit.*.unfinished-* 2>/dev/null | wc -l)" = 2 ]; }
awaited both_begun
kill -9 $!
wait $! 2>/dev/null
check "a killed run leaves files that are not finished" test "$(ls -d hit.*.unfinished-* | wc -l)" = 2
"$BUILD/touchstone" run -q -m ipsc860 -n 2 --trace hit.trace --record hit.schedule ring >/dev/null 2>&1
check "the next that writes there removes them" test "$(ls -d hit.* | xargs)" = "hit.schedule hit.trace"

# Faults.
"$BUILD/touchstone" run -q -m delta -n 32 --trace long.trace "$BUILD/app/model" -sphere 64 64 17 >/dev/null 2>&1
head -c $(($(stat -c %s long.trace) * 3 / 4)) long.trace >cut.trace
"$BUILD/touchstone" trace info cut.trace >out 2>err
check "a trace that was cut off is read as far as it goes" grep -q 'cut off: the run was killed' out
echo no trace >no.trace
"$BUILD/touchstone" trace info no.trace >out 2>err
check "what is no trace: exit status" test $? = 65
check "what is no trace: it says so" grep -q 'no.trace: not a trace of touchstone run --trace' err
{ head -c 600 all.trace; head -c 3000 /dev/urandom; } >bad.trace
"$BUILD/touchstone" trace info bad.trace >out 2>err
check "a damaged trace does no harm" test $? -le 65
"$BUILD/touchstone" run -q --trace-from 3 -n 2 ring >out 2>err
check "--trace-from without --trace" grep -q 'need --trace FILE' err
"$BUILD/touchstone" run -q --trace x.trace --trace-nodes 3- -n 2 ring >out 2>err
check "--trace-nodes: a wrong list" grep -q "takes nodes such as 0-7,12, not '3-'" err
"$BUILD/touchstone" run -q --trace x.trace --trace-nodes 3 -n 2 ring >out 2>err
check "--trace-nodes: none of the run's" grep -q -e '--trace-nodes: nodes are 0 to 1' err
for command in "trace info" "trace show" "trace why" "trace export -f csv --table waits" "page x.html"; do
    # shellcheck disable=SC2086
    "$BUILD/touchstone" $command --nodes 8-9 part.trace >out 2>err
    check "$command: nodes that the run has not" eval "test $? = 65 && said 'part.trace has none of these nodes: it has nodes 0 to 7'"
done
"$BUILD/touchstone" trace show --nodes 4 part.trace >out 2>err
check "trace show: a node that was not traced" said 'has nothing of these nodes: they were not traced'
"$BUILD/touchstone" run -q --trace /nowhere/x.trace -n 2 ring >out 2>err
check "a folder that is not there: exit status" test $? = 74
