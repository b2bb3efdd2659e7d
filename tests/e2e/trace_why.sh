#!/bin/bash
# trace_why.sh - touchstone trace why: its path fills the run's time, its causes are the nodes' idle time, handlers and disks are
# named where they are the cause, and re-runs take exactly the time that such a run takes.
. "$(dirname "$0")/common.bash"
compile ring
compile served

why() { # ARGS...: leaves out, err and status
    "$BUILD/touchstone" trace why "$@" >out 2>err </dev/null
    status=$?
}
traced() { "$BUILD/touchstone" run -q --json run.json --trace t.trace "$@" >/dev/null 2>&1; }
prints() { tr '\n' ' ' <out | grep -qE -- "$1"; } # across the ends of lines
ps() { awk -v key="\"$1\":" '$1 == key { sub(/,$/, "", $2); printf "%.0f\n", $2; exit }' "$2"; }
# Of run.json: a figure in seconds, added up over all nodes and the host, in picoseconds.
added() { awk -v key="\"$1\":" '$1 == key && /^   "/ { sum += int($2 * 1e12 + 0.5) } END { printf "%.0f\n", sum }' run.json; }
end_of_run() { awk '$1 == "\"virtual_time_s\":" { printf "%.0f\n", $2 * 1e12 }' run.json; }

# Do the lines of --path follow each other from 0 to the run's end?
tiles() {
    why --path t.trace
    tail -n +2 out | sed 's/\.//g' | awk -v end="$(end_of_run)" \
        '$1 + 0 != at || $2 + 0 <= at { print "line", NR, at; bad = 1; exit } { at = $2 + 0 } END { exit bad || at != end }'
}
same_idle() { why --json - t.trace && [ "$(ps idle_ps out)" = "$(added idle_s)" ] && [ "$(ps idle_ps out)" -gt 0 ]; }
causes() { awk '/"by_cause_ps"/ { on = 1; next } on && /}/ { exit } on { sub(/,$/, ""); sum += $2 } END { printf "%.0f\n", sum }' out; }
promises() { # NAME ARGS...
    traced "${@:2}"
    check "$1: the path's steps fill the time of the run" tiles
    check "$1: the waits are the nodes' idle time" same_idle
    check "$1: the causes add up to that" eval '[ "$(causes)" = "$(ps idle_ps out)" ]'
}
promises "the model program" -m delta -n 16 "$BUILD/app/model" -sphere 48 48 9 -group 8
promises "files" -m ipsc860 -n 4 served

# A ring: messages are the cause, and there is no wait without one.
promises "ring" -m ipsc860 -n 16 ring
why t.trace
check "ring: the sentences come first" eval "head -1 out | grep -q '^ring took [0-9.]* ms on 16 nodes of ipsc860\.'"
check "ring: a head names the steps, above its columns" \
    eval 'grep -q "^Critical path, [0-9,]* steps  .* if it took no time    times faster$" out'
check "ring: its cause is the network" prints 'the largest cause is the network'
check "a program as old as the run: no warning" eval '[ ! -s err ]'
touch ring
why t.trace
check "a program that is younger than its trace is named" eval "grep -q '^touchstone trace why: .*/ring is younger than t.trace: ' err && [ \$status = 0 ]"
mv ring elsewhere
why t.trace
check "a program that has gone is named" eval "grep -q '^touchstone trace why: .*/ring cannot be read: no function or line' err && [ \$status = 0 ]"
mv elsewhere ring
touch -r t.trace ring
why t.trace
check "ring: where nodes waited" prints 'in crecv at ring.c:15 \(main\), for types 1 to 12 of several nodes, from csend at ring.c:17 \(main\)'
"$BUILD/nxcc" -O2 -g -o farm "$tests/../../share/examples/exercises/farm.c"
"$BUILD/touchstone" run -q -m delta -n 64 --trace farm.trace farm 500 >/dev/null 2>&1
why farm.trace
check "a farm: a sentence about the path has the table's share" \
    eval "prints \"largest cause is the system's work for calls: 41.4 % of the path\" && prints \"system: the program's calls +26.862 +41.39 \""
check "a farm: the sender was in a call" prints 'because the sender was in a call'
cat >five.c <<'END'
#include <nx.h>
#include <stdio.h>
static volatile double x;
#define WORK(name, k) __attribute__((noinline)) static void name(void) { for (int i = 0; i < 20000; i++) x += k; mclock(); }
WORK(first, 1) WORK(second, 2) WORK(third, 3) WORK(fourth, 4) WORK(fifth, 5)
int main(void)
{
    first(), second(), third(), fourth(), fifth();
    printf("%f\n", x);
    return 0;
}
END
"$BUILD/nxcc" -O2 -g -o five five.c
traced -m delta five
why t.trace
check "two of five functions are not most of the work" prints 'the program computed, among others in [a-z]+ \([0-9.]+ m?s\) and [a-z]+ \('
cat >last.c <<'END'
#include <nx.h>
#include <stdio.h>
int main(void)
{
    mclock();
    printf("%f %f %f\n", 1.5, 2.5, 3.5);
    return 0;
}
END
"$BUILD/nxcc" -O2 -g -o last last.c
traced -m delta -n 1 last
why t.trace
check "what a program does behind its last call counts for the function of that call" eval "prints 'mostly in main ' && ! prints 'not known'"
traced -m ipsc860 -n 16 ring
why --json - t.trace
check "ring: nothing is unknown" eval "grep -q '\"unknown\": 0' out"
"$BUILD/touchstone" trace why --json why.json --path t.trace 2>err | true
check "ring: JSON is whole where nobody reads the text" grep -q '"begin_ps"' why.json
why --path t.trace
check "ring: the path's places stand in one column" \
    eval "test \"\$(awk '/csend at|type [0-9]+, / && match(\$0, /  (csend at|type)/) { print RSTART }' out | sort -u | wc -l)\" = 1"
why --json - --path t.trace
check "ring: JSON has each step" eval '[ "$(grep -c "\"begin_ps\"" out)" -ge "$(ps step_count out)" ]'
why --rerun t.trace
check "ring: long messages cross a network that takes no time" prints 'would take [0-9.]+ ms instead of [0-9.]+ ms \([0-9.]+ times faster\) if the network took no time'

# A node that serves others: its handlers are the cause. More others, more of that.
promises "served" -m ipsc860 -n 32 served
cp t.trace many.trace
why many.trace
check "served: node 0 decides" prints 'Node 0 decides how long the run takes'
check "served: handlers are the cause" prints 'serving the others keeps node 0 from its own work: their messages take [0-9.]+ s, 7[0-9.]+ % of the run, the larger part of it in handlers'
check "served: each request is one" prints '620 handlers took [0-9.]+ s \([0-9.]+ %\), mostly for work \([0-9.]+ s\); entering and leaving them took 0.062 s of it'
check "served: others wait for the handler" prints 'handler busy +in crecv at served.c:29 \((main|ask)\), for type 1 of node 0, from csend at served.c:21 \(serve\)'
check "served: the file is waited for" prints 'disk +in cwrite at served.c:42 \(main\)'
traced -m ipsc860 -n 2 served
why --than t.trace many.trace
check "--than: what grew" prints 'The run of t.trace, on 2 nodes, took [0-9.]+ m?s. This one took [0-9.]+ m?s more. On the critical path, handlers grew most'
check "--than: the sentence has the digits of the table" \
    eval 'prints "This one took $(awk "/^  all / && NF == 4 { print substr(\$NF, 2); exit }" out) m?s more"'
check "--than: its columns are aligned" test "$(sed -n '/^Critical path, .* this run/,/^$/p' out | awk 'NF { print length }' | sort -u | wc -l)" = 1
check "waits' causes: the longest first" \
    eval "sed -n '/^Waits of all nodes, by cause/,/all idle time/p' out | sed '1d; \$d' | awk '{ print \$(NF - 1) }' | sort -nrc"
why --nodes 5 many.trace
check "--nodes: waits of one node" prints 'Waits of some nodes.* 1  handler busy'
why --from 20ms --to 30ms many.trace
check "--from, --to: a part" prints 'Only the part from 0.020 s to 0.030 s counts here'

# One node that makes no call.
echo 'int main(void) { volatile int x = 0; while (x < 1000) x += 1; return 0; }' >alone.c
"$BUILD/nxcc" -O2 -o alone alone.c && traced -m delta -n 1 alone
why t.trace
check "alone: one step, and nothing is very many times faster but its table's row" \
    eval 'grep -q "^Critical path, 1 step  " out && [ "$(grep -c "very many" out)" = 1 ]'
check "alone: no call names a function, and nobody waited" eval 'prints "main or others" && prints "No node waited\."'

# The function that worked, which made no call itself, not that of the next call.
"$BUILD/nxcc" -O2 -g -o steps "$tests/steps.c" && traced -m delta -n 4 steps
why t.trace
check "steps: the function between two readings of the clock" prints 'computed, mostly in work \([0-9.]+ ms\) and tidy \([0-9.]+ ms\)\.'
check "steps: shares are of the run, in sentences as in tables" prints '\(99\.7 %\) the program computed.* computing +[0-9.]+ +99\.70 '
check "steps: it is the first of its table" eval 'grep -A1 "^Of the path, by function" out | grep -q "^  work "'
check "steps: what works behind the last call, too" prints ' tidy +99\.[0-9]+ .* 5  '
"$BUILD/nxcc" -O2 -g -o wrapped "$tests/wrapped.c" && traced -m delta -n 4 wrapped
why t.trace
check "wrapped: the function that works behind its call" prints 'computed, mostly in unpack \([0-9.]+ ms\)\.'
traced -m delta -n 4 wrapped away
why t.trace
check "wrapped: the function that works between two calls of another" prints 'computed, mostly in grind \([0-9.]+ ms\)\.'

"$BUILD/nxcc" -O2 -g -o levels "$tests/levels.c" && traced -m delta -n 4 levels
why t.trace
check "levels: the function below those that a round left and entered" prints 'computed, mostly in force \([0-9.]+ ms\)'
check "levels: the function before the first call" prints 'Of the path, by function.* force +[0-9. ]+ fill +[0-9.]+ '

# Node 1 decides, and waits once itself, for node 2.
cat >decides.c <<'END'
#include <nx.h>
static void work(long n) { volatile double s = 0; while (n--) s += n; }
int main(void)
{
    char c = 0;
    if (mynode() == 2)
        work(1000), csend(1, &c, 1, 1, 0);
    if (mynode() == 1)
        crecv(1, &c, 1), work(9000), csend(2, &c, 1, -1, 0);
    else
        crecv(2, &c, 1);
    return 0;
}
END
"$BUILD/nxcc" -O2 -o decides decides.c
traced -n 3 decides
why t.trace
check "the waits of the node that decides are not among those of the others" prints \
    'The other nodes waited for [0-9.]+ % of their time, [0-9.]+ ms in all\. Of all waiting, 100(\.0)? % was for node 1: '
head -2 decides.c >even.c
echo 'int main(void) { work(9000); gsync(); return 0; }' >>even.c
"$BUILD/nxcc" -O2 -o even even.c
traced -n 3 even
why t.trace
check "of nodes that all work for the whole run none decides" eval \
    'prints "none of them alone decides how long it takes\." && prints "only less of it on all nodes, or" && ! prints "Node [0-9] decides"'
head -2 decides.c >parts.c
cat >>parts.c <<'END'
int main(void)
{
    char c = 0;
    if (mynode() < 2)
        work(mynode() ? 9000 : 6000), csend(mynode(), &c, 1, 2, 0);
    else
        crecv(0, &c, 1), crecv(1, &c, 1);
    return 0;
}
END
"$BUILD/nxcc" -O2 -o parts parts.c
traced -n 3 parts
why t.trace
check "all shares of a sentence are of all waiting" prints \
    'Of all waiting, 6[0-9]\.[0-9] % was for node 0: 6[0-9]\.[0-9] % because the sender still computed\.'

# What if.
run -q --json run.json -m ipsc860 -n 32 --set system.interrupt_us=0 served
why --set system.interrupt_us=0 many.trace
check "--set: the time that such a run takes" prints "would take $(awk -v ps="$(end_of_run)" 'BEGIN { printf "%.3f", ps / 1e12 }') s instead of [0-9.]+ s \([0-9.]+ times faster\) with system.interrupt_us=0"
why --cpu 2 many.trace
check "--cpu" prints 'times faster\) if the processors computed 2 times faster'
why --rerun -o answers many.trace
check "--rerun: all that may be free" test "$(grep -c '  would .* if ' answers)" = 7
check "--rerun: nothing failed" eval '! grep -q "no answer" answers'
why --set system.nothing=0 many.trace
check "--set: a wrong key is the user's mistake: exit status" ended_with 64
check "--set: a wrong key is refused before any run" eval "said 'system.nothing=0: nothing: unknown key' && ! said done && [ ! -s out ]"
why --set node.memory_mb=2 --set node.system_kb=1024 --set node.stack_kb=1000 many.trace
check "--set: a re-run that fails is that row's answer" prints 'no answer with node.memory_mb=2,'
check "--set: a re-run that fails: exit status" ended_with 65
check "no other file is left" test "$(echo answers*)" = answers
cp served before && "$BUILD/nxcc" -O0 -o served "$tests/served.c"
why --rerun many.trace
check "--rerun: the program has changed: exit status" ended_with 65
check "--rerun: it says so" said 'takes [0-9.]+ s now, not [0-9.]+ s: the program, its input or the machine file has changed'
cp before served
cat >goes_on.c <<'END'
#include <stdio.h>
int main(void)
{
    FILE *again = fopen("again", "r");
    for (volatile double x = 0; again; x++)
        if (x == 1e6)
            fclose(fopen("begun", "w"));
}
END
"$BUILD/nxcc" -O2 -o goes_on goes_on.c 2>compile.err
run -q --trace goes_on.trace goes_on
touch again
setsid env --default-signal=INT "$BUILD/touchstone" trace why --rerun goes_on.trace >out 2>err </dev/null &
awaited test -e begun
kill -INT -$!
wait $!
status=$?
check "Ctrl-C while it runs again: its status is the signal's" ended_with 130
mkdir files && traced -m ipsc860 -n 4 --cfs files served && echo mine >files/served
why --cpu 3 t.trace
check "--rerun: the files of /cfs stay as they are" eval "[ \$status = 0 ] && echo mine | cmp - files/served"

# Faults.
head -c $(($(stat -c %s many.trace) / 2)) many.trace >cut.trace
why cut.trace
check "a trace that was cut off: as far as it goes" test "$status" -le 65
why no.trace
check "no trace: exit status" ended_with 65
why
check "which trace?: exit status" ended_with 64
why --top 0 many.trace
check "--top 0: exit status" ended_with 64
why -o /nowhere/x many.trace
check "a folder that is not there: exit status" ended_with 74

# Of 32 nodes, a million seconds each.
printf '#include <unistd.h>\nint main(void) { sleep(1000000); return 0; }\n' >long.c
"$BUILD/nxcc" -O2 -o long long.c
traced -n 32 long
why --json long.json t.trace
check "waits of more picoseconds than 64 bits hold" prints 'waited for more than 99\.9 % of their time, 31000000\.0 s in all.* all idle time +32000000\.000 +100\.00'
check "and so in the file" grep -q '^  "idle_ps": 3.2e19,' long.json

traced --trace-nodes 1 -n 4 ring
why t.trace
check "a trace of one node: not that it decides" eval '! prints " decides how long|All nodes work" && prints "its largest part, [0-9.]+ %, is on node 1|is on node 1 alone"'
