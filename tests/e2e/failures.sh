#!/bin/bash
# failures.sh - programs that fail: touchstone's messages and exit status.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
for p in deadlock crash quits endless greedy flood; do compile $p; done

run -n 4 deadlock
check "deadlock: exit status 2" ended_with 2
check "deadlock: a line for each node, with call, type and since when" \
    test "$(grep -cE '^  node [0-3]: ((crecv|cprobe|msgwait)\(-?[0-9]+\)|gsync) since [0-9.]+ [mun]?s' err)" = 4
check "deadlock: and the source line" said "^  node 0: crecv\(7\) since [0-9.]+ [mun]?s \(deadlock\.c:$(grep -n 'crecv(7' "$tests/deadlock.c" | cut -d: -f1)\)"
check "deadlock: crecv names its type" said '^  node 0: crecv\(7\) since'

run -n 4 crash
check "crash: exit status 1" ended_with 1
check "crash: node and virtual time" said 'node 1 crashed at .*[0-9]+ [mu]s'
check "crash: backtrace with function and line" said 'in read_it.*crash\.c:8'
check "crash: backtrace goes up to its callers" said 'ask_for_it.*crash\.c'

run -n 3 quits
check "exit(3) in a node: exit status 1" ended_with 1
check "exit(3) in a node: it is named" said 'node 1 ended at .* with exit\(3\) \(quits\.c:13\)$'
check "exit(3) in a node: once, if nothing waits for it" test "$(grep -c 'exit(3)' err)" = 1
check "exit(3) in a node: the others go on" test "$(cat out)" = "$(printf 'node 0 is done\nnode 2 is done')"
run -n 3 quits why
check "a report after the program's own words begins a line" said '^touchstone run: node 1 ended at .* with exit\(3\)'
check "and the program's have theirs" test "$(head -1 err)" = "no input"
run -n 3 quits why all
check "so does the summary" said '^virtual time '
run -q -n 3 quits why all
check "without a report the program's words stay as they are" test "$(cat err; echo .)" = "no inputno inputno input."

run --max-virtual-time 2.5 endless
check "--max-virtual-time: exit status 1" ended_with 1
check "--max-virtual-time: says so" said 'virtual time limit of 2\.5 s'

# Both engines have the line of a program that had passed a slice boundary without a poll, and the time of its crash.
compile far
for how in "" crash; do
    run -q -n 3 --max-virtual-time 0.0028 far $how
    mv err fast.err
    run -q -n 3 --max-virtual-time 0.0028 --engine reference far $how
    check "past a slice boundary without a poll: the engines say the same $how" diff fast.err err
    check "and the line $how" said '\(far\.c:[0-9]+\)'
done

limited "$BUILD/touchstone" run --max-wall-time 1 endless >out 2>err
status=$?
check "--max-wall-time: exit status 1" ended_with 1
check "--max-wall-time: says so" said 'wall time limit of 1 s'

run -n 2 greedy
check "memory: malloc gives NULL when the node's 16 MB are used" ended_with 0
check "memory: a node of 16 MB has 13 or 14 for the program's heap" grep -qxE '1[34] MB' out
run -n 2 greedy careless
check "memory: the crash of a program that does not look says what was short" said 'memory was exhausted'

run -n 2 flood
check "flood: messages fill the receiver's memory, and the sender waits" ended_with 2
check "flood: the sender is named" said '^  node 0: csend\(5\) since'

# --- short messages find room, but not for ever ---
cat >floods.c <<'E'
#include <nx.h>
int main(int argc, char **argv)
{
    long x = 0;
    while (mynode() != 1)
        csend(5, &x, sizeof x, 1, 0);
    if (argc == 1)
        crecv(6, &x, sizeof x);
    return 0;
}
E
"$BUILD/nxcc" -O2 -g -o floods floods.c
for how in "" "--engine reference" "-w 3"; do
    # shellcheck disable=SC2086
    run -q -n 2 $how floods
    check "short messages for ever, $how: an error" ended_with 1
    check "short messages for ever, $how: how many, which, from whom" \
        said '^touchstone run: node 1 is flooded: at 20\.33[0-9]* s, 493448 messages of 3947592 bytes .* 493448 of them are of type 5, 493448 of these from node 0$'
    check "short messages for ever, $how: what the receiver waits in, and where" \
        eval "said '^  node 1 waits in crecv\\(6\\) since' && said 'called from main.*\\(floods.c:8\\)'"
done
run -q -n 2 --max-unreceived 1 floods
check "--max-unreceived: so much, and 128 bytes for each" said '^touchstone run: node 1 is flooded: at .* ms, 77[0-9]* messages '
run -q -n 3 --max-unreceived 1 floods ends
check "short messages to a program that has ended" said '^  the program of node 1 ended at '
run -q -n 2 --max-unreceived 100 --max-virtual-time 25 floods
check "--max-unreceived: more room than usual" said 'virtual time limit of 25 s'

# --- virtual time has an end, before its picoseconds are more than 64 bits hold ---
cat >lasts.c <<'E'
#include <nx.h>
#include <unistd.h>
int main(void)
{
    sleep(4000000000u); /* to the last moment that can be waited for */
    for (;;)
        csend(5, NULL, 0, mynode(), 0), crecv(5, NULL, 0);
}
E
"$BUILD/nxcc" -O2 -g -o lasts lasts.c
for how in "" "--engine reference" "-w 3"; do
    # shellcheck disable=SC2086
    run -q -n 2 $how --set system.call_us=1e6 --set system.short_send_us=1e6 lasts
    check "the end of virtual time, $how: exit status 1" ended_with 1
    check "the end of virtual time, $how: says so" said '^touchstone run: virtual time ends at 17946744\.073709551 s$'
    [ -n "$how" ] || cp err first.err
    check "the end of virtual time, $how: where the nodes are, in any run" diff first.err err
done
