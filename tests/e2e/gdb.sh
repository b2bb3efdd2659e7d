#!/bin/bash
# gdb.sh - gdb sees node programs as it sees any program: functions, lines, arguments, locals, each node's own variables, a thread
# a node; and a run in gdb gives what it gives without. Needs gdb.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
for option in O0 O2; do
    "$BUILD/nxcc" -g -$option -Wall -o gdb$option "$tests/gdb.c" "$tests/gdb_part.c" || echo "not ok gdb.c compiles"
done
compile deadlock
compile crash
export ASAN_OPTIONS=detect_leaks=0 # it cannot be traced
mkdir tmp
echo 'set width 0' >.gdbinit
export TMPDIR=$work/tmp
line() { grep -n -m1 "$1" "$tests/${2:-gdb.c}" | cut -d: -f1; }

# in_gdb COMMAND... -- ARGS: gdb commands, on touchstone run ARGS; leaves out
in_gdb() {
    local commands=(-ex 'set breakpoint pending on' -ex 'set width 0' -ex 'set print thread-events off')
    while [ "$1" != -- ]; do
        commands+=(-ex "$1")
        shift
    done
    shift
    limited gdb -nx -batch "${commands[@]}" --args "$BUILD/touchstone" run "$@" </dev/null >out 2>&1
}
# started ARGS <COMMANDS: touchstone run ARGS, which start gdb
started() {
    cat >gdb.in
    HOME=$work limited "$BUILD/touchstone" run "$@" <gdb.in >out 2>&1
    status=$?
}
shows() { grep -qE -- "$1" out; }
results() { sed 's/^(gdb) //' out | grep -E '^(virtual time|messages|nodes  |memory|digest|node [0-9])' | sort; }

# --- an editor: what share/editor/launch.json has it give gdb ---
launch=$tests/../../share/editor/launch.json
setting() { jq -r ".configurations[0]$1" "$launch"; }
check "launch.json is for gdb" test "$(setting .MIMode)" = gdb
{
    setting '.setupCommands[] | "-interpreter-exec console \"\(.text)\""'
    echo "-break-insert -f gdb.c:$(line 'change = relax')"
    printf '%s\n' -exec-run
    awaited grep -q '^\*stopped' out
    printf '%s\n' '-data-evaluate-expression me' -gdb-exit
} | limited gdb -nx -q --interpreter=mi2 --args "$BUILD/touchstone" $(setting '.args[:-1][]') gdbO0 >out 2>&1
check "a breakpoint in a line, set before the run" shows '^\*stopped,.*reason="breakpoint-hit".*func="main".*file="[^"]*gdb\.c"'
check "and a variable" shows '^\^done,value="[0-3]"$'

# --- plain gdb ---
run -n 4 gdbO0
cat err >>out
results >plain
in_gdb 'break relax if me == 2 && round == 3' run bt 'info args' 'print rounds_done' 'print me' 'print width' 'print row[0]' 'up' \
    'info locals' 'info threads' 'thread 5' 'frame function main' 'print me' 'info symbol main' 'delete' 'continue' -- -n 4 gdbO0
check "a breakpoint in a function, hit by node 2" \
    shows '^Thread [0-9]+ "node 2" hit Breakpoint 1\.[0-9]+, relax \(cell=0x[0-9a-f]+ <row>, width=64, round=3\) at .*gdb\.c:[0-9]+$'
check "the calls under way: main, with its line" shows "^#1 .* in main \(\) at .*gdb\.c:$(line 'change = relax')\$"
check "a global variable of another file is node 2's" shows '^\$1 = 2$'
check "one of the same file" shows '^\$2 = 2$'
check "an argument" shows '^\$3 = 64$'
check "a static array: what node 1 has sent" shows '^\$4 = 1002$'
check "locals of main" shows '^nodes = 4$'
check "locals of main that the run computes" shows '^began = 0\.00[0-9]+$'
for node in 0 1 2 3; do
    check "node $node is a thread" shows "Thread .* \"node $node\""
done
check "another thread's variables are its node's" shows '^\$5 = 3$'
check "a run in gdb gives what it gives without" cmp plain <(results)
in_gdb 'break relax' run 'print $_thread' c 'print $_thread' c 'print $_thread' c 'print $_thread' 'delete' c -- \
    --engine reference -n 4 gdbO0
check "the reference engine, too: all nodes come to the breakpoint" test "$(grep -cE '^\$[1-4] = [2-5]$' out)" = 4
check "and the results are the same" cmp plain <(results)
run -n 4 gdbO2
cat err >>out
results >plain
in_gdb 'break relax' run 'bt' 'delete' c -- -w 4 -n 4 gdbO2
check "optimised, too: the function is found" shows '^#[01] .* relax \(.*gdb\.c'
check "and the results are the same" cmp plain <(results)
run -n 4 --max-wall-time 1e-6 gdbO2
check "no run keeps a limit of a microsecond" said 'wall time limit of 1 us reached'
in_gdb run -- -n 4 --max-wall-time 1e-6 gdbO2
check "in gdb there is no limit of real time" cmp plain <(results)
in_gdb 'break relax if me == 500' run 'print me' 'info threads' 'delete' c -- -n 512 gdbO2
check "512 nodes: a breakpoint on one" shows '^\$1 = 500$'
check "512 nodes: a thread each" test "$(grep -c '"node [0-9]*"  ' out)" = 512
in_gdb 'break relax if me == 2' run 'print me' bt kill 'run' 'print rounds_done' -- -n 4 gdbO0
check "the run can be started again" test "$(grep -c 'hit Breakpoint' out)" = 2
mkdir other
cp gdbO0 other
in_gdb 'break relax if me == 3' run 'print me' 'print width' 'delete' c -- -q -n 2 gdbO0 : -n 1 gdbO0 : -n 1 other/gdbO0
check "several programs of one name: each node has its own variables" shows '^\$1 = 3$'
# As a user's Ctrl-C.
(
    interrupted() {
        for process in /proc/[0-9]*; do
            [ "$(readlink "$process/cwd")" = "$work" ] && [ "$(cat "$process/comm")" = touchstone ] &&
                [ "$(ls "$process/task" | wc -l)" = 4 ] && has_computed "${process#/proc/}" 150 && kill -INT "${process#/proc/}" &&
                return
        done 2>/dev/null
        return 1
    }
    awaited interrupted
) &
compile stopped
in_gdb run 'print $_gthread' bt -- -q -n 3 stopped for
wait
loop=$(grep -n -m1 'for (;;)' "$tests/stopped.c" | cut -d: -f1)
check "an interrupt stops the node that computes, in its endless loop" shows "^#0 .*main \\(.*stopped\\.c:($loop|$((loop + 1)))\$"
in_gdb run bt -- -n 2 crash
check "a crash stops where it happens" shows "received signal SIGSEGV"
check "with the calls" shows "^#2 .* in main \(\) at .*crash.c"
in_gdb run 'thread 3' 'frame function main' -- -q -n 3 deadlock
check "a deadlock stops" shows 'received signal SIGTRAP'
check "while each node is where it waits" shows "^#[0-9]+ .* in main \(\) at .*deadlock.c:$(line cprobe deadlock.c)\$"

# --- touchstone run --gdb ---
started -n 4 --gdb 2 gdbO0 <<'END'
bt
next
next
next
next
print me
continue
END
check "--gdb 2: stops at main, on node 2" \
    shows '"node 2" hit Temporary breakpoint .* main \(\) at .*gdb\.c:'"$(line 'int main' | awk '{ print $1 + 1 }')"'$'
check "next goes to the next line" shows "^\(gdb\) $(line 'me = mynode')[[:space:]]+me = mynode"
check "and over calls" shows '^\(gdb\) \$1 = 2$'
run -n 4 gdbO0
cat err >>out
results >plain
for engine in fast reference; do
    started -n 4 --engine $engine --gdb 2 --at 4ms gdbO0 <<END
print me
print row[0] > 0
frame function main
print began <= 0.004
tbreak gdb.c:$(line csend) if me == 2
continue
print began > 0.004
continue
END
    check "$engine: --at 4ms: how far all have come" \
        shows '^touchstone run: all nodes have come to 4 ms; node 2: computing \(gdb\.c:[0-9]+\)$'
    check "$engine: it stops in node 2's program" shows '"node 2" hit Temporary breakpoint .*relax \(.* at .*gdb\.c:[0-9]+$'
    check "$engine: whose variables are there" shows '^\(gdb\) \$1 = 2$'
    check "$engine: not later than in the round of that time" shows '^\(gdb\) \$3 = 1$'
    check "$engine: and not earlier" shows '^\$4 = 1$|^\(gdb\) \$4 = 1$'
    check "$engine: the run gives what it gives without" cmp plain <(results)
done
started -n 4 --gdb 3 --at 45us deadlock <<'END'
info locals
END
check "in a call: which, since when, and where" shows "node 3: gsync since [0-9.]+ [mun]?s \(deadlock\.c:$(line gsync deadlock.c)\)"
check "in a call: main is shown" shows "^#[0-9]+ .* in main \(\) at .*deadlock.c:$(line gsync deadlock.c)\$"
started -n 4 --gdb 0 --at 5s gdbO2 <<<''
check "a time that never comes is said" shows 'the run has ended before'
check "and the results are there" shows '^digest'
"$BUILD/nxcc" -host -g -O1 -o ends_host "$tests/host/again.c" 2>compile.err
for p in ends counts endless posts sends; do "$BUILD/nxcc" -host -g -O1 -o $p "$tests/host/$p.c" 2>>compile.err; done
started -n 4 --gdb host --host ends_host <<'END'
bt
break counts.c:main
continue
print $_thread > 1
END
check "a host program" shows '"host" hit Temporary breakpoint .* main \(\) at .*again\.c'
check "and a program that it loads later" shows '"node 1" hit Breakpoint .* main .* at .*counts\.c'

# --- what is wrong ---
run --at 1ms gdbO2
check "--at without --gdb: said" said '--at needs --gdb NODE'
run -n 4 --gdb 4 gdbO2
check "a node that is not there: said" said '--gdb 4: nodes are 0 to 3'
run --gdb x gdbO2
check "no number: said" said "--gdb takes a node's number, from 0 up, or 'host', not 'x'"
run --gdb 0 --at soon gdbO2
check "no time: said" said "--at takes a virtual time such as 1.5s, 12ms or 3us, not 'soon'"
PATH=$work run --gdb 0 gdbO2
check "no gdb: said, with what to do" said 'gdb cannot be started: No such file or directory: install it.*apt install gdb'
check "no gdb: status 65" ended_with 65
touch -d '1 hour ago' tmp/*
in_gdb run -- -n 4 gdbO2
check "a run removes its files, and those of runs that were killed" test "$(ls tmp | wc -l)" = 0
