#!/bin/bash
# trace_export.sh - touchstone trace export: what other programs read in the files is what the run summed up, to the picosecond.
. "$(dirname "$0")/common.bash"
compile ring
read_export() { python3 "$tests/../lab/read_export.py" "$@"; }
export_trace() {
    "$BUILD/touchstone" trace export "$@" >out 2>err
    status=$?
}

# The nodes' computing, waiting and system time in each format, and the number of messages, as the run itself says.
same_as_run() { # NAME ARGS...
    local name=$1 format nodes
    shift
    rm -rf t.*
    run --trace t.trace --json t.run "$@"
    read_export run t.run >nodes
    nodes=$(grep -c '^node' nodes)
    for format in json paje otf2 picl csv; do
        export_trace -o t.$format t.trace
        check "$name: $format" ended_with 0
        check "$name: $format keeps its rules" read_export $format t.$format
        sed "s/^node $nodes /host /" check.out >found
        check "$name: $format: the nodes' times are the run's" diff nodes <(grep -v '^message' found)
        grep '^message' found | sort >messages.$format
    done
    for format in paje otf2 picl; do
        check "$name: $format has the messages that json has" cmp messages.json messages.$format
    done
}
messages_of_run() { test "$(wc -l <messages.json)" = "$(sed -n 's/^ "messages": \([0-9]*\).*/\1/p' t.run)"; }

same_as_run "ring" -m ipsc860 -n 8 ring
check "ring: all messages have an arrow" messages_of_run
same_as_run "ring on a mesh" -m delta -n 6 ring
same_as_run "the model program" -m ipsc860 -n 16 "$BUILD/app/model" -sphere 48 48 9 -group 4
check "the model program: there are handlers" grep -q '"name":"handler"' t.json
check "and messages" test "$(wc -l <messages.json)" -gt 100
check "what msgwait is given is an id, no type" eval "grep -q '\"name\":\"msgwait\".*\"id\":1,' t.json && ! grep -q '\"name\":\"msgwait\".*\"type\":' t.json"
export_trace -f csv --table calls t.trace
check "nor in the table of calls, where others have theirs" awk -F, '
    $5 == "msgwait" { wrong += $7 != ""; ids++ }
    $5 == "csend" { wrong += $7 == "" }
    END { exit wrong || !ids }' out

# A part.
run -m ipsc860 -n 8 --trace ring.trace ring
export_trace --from 10ms --to 20ms --nodes 0-2 -o part.json ring.trace
check "an interval and some nodes" read_export json part.json
cp check.out part
check "are those nodes" test "$(grep '^node' part | cut -d' ' -f1,2 | tr '\n' ' ')" = "node 0 node 1 node 2 "
check "for that long" awk '/^node/ && $4 + $6 + $8 != 1e10 { exit 1 }' part

# The examples of the page.
page=$tests/../../doc/trace-export.md
ln -s "$BUILD" build && ln -s "$tests/.." tests
for n in 1 2; do
    block "$page" out $n >expected
    block "$page" sh $n >commands
    bash -e commands >out 2>err
    check "doc/trace-export.md: example $n" cmp out expected
done

# Standard output, tables, names.
export_trace -o ring.json ring.trace
cp ring.json whole.json
export_trace -f json ring.trace
check "standard output" cmp out ring.json
export_trace -f json -o - ring.trace
check "-o -" cmp out ring.json
check "no progress is shown where there is no terminal" test ! -s err
script -qec "$BUILD/touchstone trace export -o again.json ring.trace" /dev/null </dev/null >terminal
check "on a terminal: what is read" grep -qF $'\rreading ring.trace ...' terminal
for table in pieces calls waits handlers systems messages blocks; do
    export_trace -f csv --table $table ring.trace
    cp out $table.csv
    check "table $table" read_export table $table.csv
done
check "each message is a row" test "$(wc -l <messages.csv)" = 97
export_trace -o both.csv ring.trace
check "without --table: two files" cmp both-messages.csv messages.csv
check "and the other" cmp both-pieces.csv pieces.csv
check "no third" test ! -e both.csv
mkdir other && ln -s other/there link.json && : >other/there
export_trace -o link.json ring.trace
check "a link is written through" cmp other/there whole.json
check "and stays one" test -L link.json

# Faults.
wrong() { # WORDS ARGS...
    local words=$1
    shift
    export_trace "$@"
    check "$* is an error" ended_with 64
    check "that says '$words'" said "$words"
}
wrong 'which trace' -f json
wrong 'which format' ring.trace
wrong 'which format' -o ring.xyz ring.trace
wrong "takes json, paje, otf2, picl or csv, not 'xml'" -f xml ring.trace
wrong 'otf2 is a folder: say --output' -f otf2 ring.trace
wrong 'standard output takes one table' -f csv ring.trace
wrong "takes pieces, calls.* not 'rows'" -f csv --table rows ring.trace
wrong '[-]-table is for --format csv' -f json --table calls ring.trace
cp ring.trace before.trace
export_trace -f json -o ring.trace ring.trace
check "the trace itself is not overwritten" cmp ring.trace before.trace
check "which is said" said 'ring.trace is the trace itself'
export_trace -o ring.otf2 ring.trace
export_trace -o ring.otf2 ring.trace
check "nor is a folder" ended_with 1
check "which is said, too" said 'ring.otf2 is already there'
echo nothing >no.trace
export_trace -o no.json no.trace
check "what is no trace" ended_with 65
check "leaves no file" test ! -e no.json
for format in json paje otf2 picl csv; do
    export_trace -o missing/x.$format ring.trace
    check "$format: a folder that is not there" ended_with 1
    check "$format: is named" said 'missing/x'
done
ln -s /dev/full full.picl
export_trace -o full.picl ring.trace
check "a disk that is full" ended_with 1
check "is said" said 'full.picl cannot be written'
(ulimit -f 0 && "$BUILD/touchstone" trace export -o large.otf2 ring.trace 2>/dev/null)
status=$?
check "no room for otf2" ended_with 1
check "leaves nothing" test -z "$(ls -d large* 2>/dev/null)"
export_trace -f otf2 -o slash.otf2/ ring.trace
check "otf2: a folder's name may end in a slash" test -s slash.otf2/traces.otf2

cat >many.c <<'END'
#include <nx.h>
int main(void)
{
    int x = 0;
    for (int k = 0; k < 40000; k++)
        if (mynode() == 0)
            csend(1, &x, sizeof x, 1, 0);
        else
            crecv(1, &x, sizeof x);
    return 0;
}
END
"$BUILD/nxcc" -o many many.c
run -q -n 2 --trace many.trace many
"$BUILD/touchstone" trace export -o stopped.otf2 many.trace 2>err &
begun() { ls -d stopped.otf2.??????; }
awaited begun >files 2>/dev/null
check "otf2 takes long" test -s files
kill -TERM $!
wait $!
check "stopped, it leaves nothing" test -z "$(ls -d stopped* 2>/dev/null)"

rm ring
mkfifo ring
limited "$BUILD/touchstone" trace export -f csv --table calls ring.trace >out 2>err
status=$?
check "a program that has become a pipe is not waited for" ended_with 0
