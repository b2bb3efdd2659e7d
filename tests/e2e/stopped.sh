#!/bin/bash
# stopped.sh - runs that a signal or a limit stops report where each node is, and lose no output; a message names results that
# cannot be written; a run never replaces a device by a file; no scratch folder is left.
. "$(dirname "$0")/common.bash"
compile stopped
compile ring

# --- loops that do nothing ---
for how in for goto asm entered longjmp calls; do
    line="node 1: .*(computing|dclock).*stopped.c:[0-9]+"
    limited "$BUILD/touchstone" run -q -n 2 --max-virtual-time 0.01 stopped $how >out 2>err
    check "$how: the limit of virtual time" said 'virtual time limit of 10 ms reached'
    [ $how = calls ] || check "$how: and where it is then" said "$line"
    run -q -n 2 --max-wall-time 0.5 stopped $how
    check "$how: the limit of real time" said 'wall time limit of 500 ms reached'
    check "$how: and where it is then" said "$line"
    run -q -n 2 --max-virtual-time 0.01 --engine reference stopped $how
    check "$how: the reference stops it, too" said 'virtual time limit of 10 ms reached'
done

# A loop in which there is no poll takes no virtual time, either.
loop=$(grep -n 'jmp 1b' "$tests/stopped.c" | cut -d: -f1)
for options in "-w 1 -n 2" "-w 2 -n 40" "--engine reference -n 2"; do
    # shellcheck disable=SC2086
    run -q $options --max-wall-time 0.1 stopped unseen
    check "$options: a loop without polls ends at the limit of real time" said 'wall time limit of 100 ms reached'
    check "$options: and where it is" said "node.* 1: computing \\(stopped.c:$loop\\)"
done

# --- signals ---
for how in for calls unseen; do
    "$BUILD/touchstone" run -q -n 2 stopped $how >out 2>err &
    child=$!
    awaited has_computed $child 25
    kill -TERM $child
    kill -TERM $child # as timeout does
    wait $child
    status=$?
    check "a signal sent twice, $how: is one" said '^touchstone run: stopped by SIGTERM'
done
mkfifo never
"$BUILD/touchstone" run -n 2 stopped reads 3<>never <&3 >out 2>err &
child=$!
awaited grep -q 'node 1 is there' out
sleeps() { [ "$(sed 's/.*) \(.\).*/\1/' /proc/$child/stat)" = S ]; } # it was still on its way to read()
awaited sleeps
ends() { ! kill -TERM $child 2>/dev/null; }
awaited ends
wait $child
status=$?
check "a second signal: ends a run that waits for its input" ended_with 143
check "a second signal: and says so" said 'ended at once, by a second signal'
for signal in INT TERM HUP; do
    for how in for calls unseen; do
        # (A shell without job control starts what is in the background with SIGINT ignored; nohup ignores SIGHUP.)
        env --default-signal=INT,TERM,HUP "$BUILD/touchstone" run -n 2 stopped $how >out 2>err &
        child=$!
        awaited has_computed $child 25
        kill -$signal $child
        wait $child
        status=$?
        check "SIG$signal, $how: ends by it" ended_with $((128 + $(kill -l $signal)))
        check "SIG$signal, $how: what the nodes printed" grep -q '^node 1 is there' out
        check "SIG$signal, $how: it is said" said "^touchstone run: (interrupted|stopped by SIG$signal)"
        check "SIG$signal, $how: where node 1 is" said 'node 1: .*stopped.c:[0-9]+'
        check "SIG$signal, $how: the summary" said '^digest'
    done
done
trap '' HUP
"$BUILD/touchstone" run -q -n 2 stopped for >out 2>err &
trap - HUP
awaited has_computed $! 30
kill -HUP $!
awaited has_computed $! 40
kill -TERM $!
wait $!
check "an ignored SIGHUP stays ignored" said 'stopped by SIGTERM'

# --- what the nodes print reaches its file while the run goes on ---
for options in "-w 1" "-w 2" "--engine reference"; do
    for how in for calls; do
        # shellcheck disable=SC2086
        "$BUILD/touchstone" run -q -n 2 $options stopped $how >out 2>err &
        check "$options, $how: output is there before the end" awaited grep -q '^node 1 is there' out
        kill -KILL $!
        wait $! 2>/dev/null
    done
    : >out
done

# --- where are the nodes? ---
asked() { # ARGS: a run that is asked, goes on, and is ended if it has no end
    "$BUILD/touchstone" run -q "$@" >out 2>err &
    child=$!
    awaited has_computed $child 25
    awaited has_answered
    [ "${*: -1}" != for ] || kill -TERM $child
    wait $child
    status=$?
}
has_answered() { ! kill -USR1 $child 2>/dev/null || { sleep 0.05 && grep -q 'of virtual time, after' err; }; }
loop=$(grep -n -m1 'for (;;)' "$tests/stopped.c" | cut -d: -f1) sync=$(grep -n 'gsync();' "$tests/stopped.c" | cut -d: -f1)
for engine in fast reference; do
    asked --engine $engine -n 5 stopped for
    check "SIGUSR1, $engine: how far the run has come" said '^touchstone run: at [0-9.]+ [mun]?s of virtual time, after [0-9]+ messages:$'
    check "SIGUSR1, $engine: the line of an endless loop" said "^  node 1: computing.* \\(stopped.c:($((loop - 1))|$loop)\\)"
    check "SIGUSR1, $engine: the run goes on" said '^touchstone run: stopped by SIGTERM'
done
asked -w 2 -n 40 stopped for
check "SIGUSR1: nodes in the same state share a line" \
    said "^  nodes 0, 2-39: gsync since [0-9.]+ [mun]?s to [0-9.]+ [mun]?s \\(stopped.c:$sync\\)"
check "a limit's report groups many nodes, too" test "$(grep -c '^  node' err)" -lt 20
messages=400000 # a second or more
[[ $BUILD != */asan ]] || messages=40000
run -q --json without.json -m cluster2026 -n 9 stopped flood $messages
asked --json asked.json -m cluster2026 -n 9 stopped flood $messages
check "SIGUSR1: the run was asked" said 'virtual time, after [0-9]+ messages'
check "SIGUSR1: and gives what it gives without" cmp <(grep -v wall_time without.json) <(grep -v wall_time asked.json)

# --- how far has it come? ---
script -qec "$BUILD/touchstone run --max-wall-time 3 --max-virtual-time 1e6 -n 2 stopped for" terminal >/dev/null </dev/null
tr '\r' '\n' <terminal >lines
check "a terminal shows how far a long run has come" grep -qE '^[0-9.]+ [mun]?s on 2 nodes, [0-9]+ messages, [0-9]+ % of 1000000 s' lines
check "and it is erased at the end" grep -qE $'\r +\r(\033\\[31m)?touchstone run:(\033\\[0m)? (\033\\[1m)?wall time limit' terminal
script -qec "$BUILD/touchstone run -n 2 ring" terminal >/dev/null </dev/null
check "a short run shows nothing of that" test "$(grep -c 's on 2 nodes, ' terminal)" = 0
run --max-wall-time 1.3 -n 2 stopped for
check "nor does a pipe" test "$(cat out err | grep -c $'\r')" = 0

# --- crashes in libraries ---
run -q -n 2 stopped printf
check "a crash in the library: in which call" said '^  in printf'
check "a crash in the library: called from where" said '^  called from (show|main).*stopped.c:'
run -q -n 2 stopped strlen
check "a crash in another: in which call" said '^  in strlen'
run -q -n 2 stopped register
check "a register that the library needs" said '^touchstone run: node 1 crashed at .* changed the register fs'
check "a register that the library needs: where" said 'called from main.*stopped.c:'
run -q -n 2 stopped "given back"
check "a register that the kernel has set right since" said '^touchstone run: node 1 crashed at .* changed the register fs'
run -n 2 stopped stream
check "a stream overwritten: the run's figures" said '^digest'
check "a stream overwritten: why it ends" said '^touchstone: a fault outside of all programs'

# --- a node is killed before it prints; then the run ends in a deadlock ---
for options in "-w 1" "-w 2" "--engine reference"; do
    # shellcheck disable=SC2086
    run -q -n 2 $options stopped killed
    check "$options, killed: nothing of what came after" test "$(grep -c later out)" = 0
    check "$options, killed: node 0 waits for it" said 'node 0: gsync'
done

# --- floods ---
seconds() { # MESSAGES
    local TIMEFORMAT=%U # of a processor
    { time run -q -m cluster2026 -n 9 stopped flood "$1"; } 2>&1
}
few=$(seconds 1250) many=$(seconds 10000)
check "80,000 messages take no more than in proportion: $few s, $many s" \
    awk -v few="$few" -v many="$many" 'BEGIN { exit !(many < 40 * (few > 0.01 ? few : 0.01)) }' # (below a tick 0 is shown)

# --- where results go ---
run -q -n 2 --json - ring
check "--json -: to standard output" grep -q '"machine": "delta"' out
check "--json -: no file of that name" test ! -e ./-
ln -s target link
touch target
run -q -n 2 --json link --history history ring
check "--json LINK: the link stays" test -L link
check "--json LINK: its target is written" grep -q '"machine"' target
check "--history: a line a message" test "$(wc -l <history)" = "$(sed -n 's/ "messages": \(.*\),/\1/p' target)"
mkfifo pipe
cat pipe >through &
run -q -n 2 --json pipe ring
wait $!
check "--json PIPE: written through" grep -q '"machine"' through
check "--json PIPE: it stays" test -p pipe
run -q -n 2 --json /dev/full ring
check "--json to a full device: said" said '/dev/full cannot be written: No space left'
check "--json to a full device: status 74" ended_with 74
full() { "$BUILD/touchstone" "$@" >/dev/full 2>err; [ $? = 74 ] && grep -q 'standard output cannot be written: No space left' err; }
check "text to a full device: said, by commands that only print, too" full machines
for asked in --help --version --machines help 'run --help' 'run --usage' 'study --help' 'help trace show' 'getcube --version'; do
    # shellcheck disable=SC2086
    check "text to a full device: said by $asked" full $asked
done
"$BUILD/nxcc" --help >/dev/full 2>err
status=$?
check "text to a full device: nxcc fails" ended_with 1
check "text to a full device: said by nxcc --help" said '^nxcc: standard output cannot be written: No space left'
ln -s endless_link endless_link
run -q -n 2 endless_link
check "a program that nobody can tell of: said why" said 'endless_link: Too many levels of symbolic links'
check "a device stays a device" test -c /dev/full
"$BUILD/touchstone" run -q -n 2 ring >/dev/full 2>err
status=$?
check "standard output full: said" said 'standard output cannot be written: No space left'
check "standard output full: status 74" ended_with 74
"$BUILD/touchstone" run -n 2 --history history ring 2>&- >/dev/null
check "standard error closed: no message gets into a result" test "$(grep -cE '^[0-9]+ [0-9]+ [0-9]+ ' history)" = "$(wc -l <history)"
"$BUILD/touchstone" run -q -n 2 --history history ring 2>err >&-
status=$?
check "standard output closed: no output gets into a result" test "$(grep -cE '^[0-9]+ [0-9]+ [0-9]+ ' history)" = "$(wc -l <history)"
check "standard output closed: said" said 'standard output cannot be written: Bad file descriptor'
check "standard output closed: status 74" ended_with 74
"$BUILD/touchstone" run -q -n 2 --json j.json ring >&- 2>err
status=$?
check "standard output closed: status 74" ended_with 74
(
    ulimit -f 1
    "$BUILD/touchstone" run -q -n 2 --history big ring 2>err >out
    echo $? >status
) 2>/dev/null
status=$(cat status)
check "a limit on files is an error of writing, or does not matter" test "$status" = 0 -o "$status" = 74

# --- what cannot be read ---
mkdir folder.cfg
printf 'title = "a";\nprogram = "ring";\nmachine = "delta";\naxes = ( { name = "how";\n cases = ( { label = "\xff"; } ); } );\n' >bad.cfg
cp -r "$tests"/../../machines/{cpu,ipsc860.cfg,ipsc860.inc} .
echo '@include "folder.cfg"' >>ipsc860.cfg
refused() { # NAME TEXT COMMAND...
    local name=$1 text=$2
    shift 2
    limited "$BUILD/touchstone" "$@" >out 2>err </dev/null
    status=$?
    check "$name: said" said "$text"
    check "$name: status 65" ended_with 65
}
refused "a machine file that is a folder" 'folder.cfg: cannot be read: it is a folder' run -m ./folder.cfg ring
refused "one that includes a folder" 'ipsc860.cfg:[0-9]+: @include: ./folder.cfg cannot be read: it is a folder' run -m ./ipsc860.cfg ring
refused "one without end" '/dev/zero: cannot be read: it is larger' run -m /dev/zero ring
refused "one that is a pipe" 'pipe: cannot be read: it is a pipe' run -m ./pipe ring
for ((i = 0; i < 10; i++)); do echo '@include "itself.cfg"'; done >itself.cfg
refused "a study that includes itself" 'itself.cfg:1: @include "itself.cfg": a file cannot include itself' study itself.cfg
echo '@include "two.cfg"' >one.cfg
printf '\n@include "one.cfg"\n' >two.cfg
refused "two that include each other" 'two.cfg:2: @include "one.cfg": a file cannot include itself, nor' study one.cfg
refused "one that is not there" 'none.cfg: cannot be read: No such file' run -m ./none.cfg ring
refused "a study that is a folder" 'folder.cfg: cannot be read: it is a folder' study folder.cfg
refused "a label that is no UTF-8" 'bad.cfg:5: a byte that is not UTF-8 text' study bad.cfg
refused "a program that is a folder" 'folder.cfg: not a regular file' run folder.cfg

# --- folders ---
mkdir tmp
cat >open.c <<'END'
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"
int main(void) { FILE *f = fopen("/cfs/a", "w"); fprintf(f, "x\n"); fclose(f); for (volatile long i = 0; i >= 0; i++) ; }
END
"$BUILD/nxcc" -O2 -o open open.c
TMPDIR=$work/tmp "$BUILD/touchstone" run -q -m ipsc860 open >out 2>err &
child=$!
has_folder() { [ -n "$(ls tmp)" ]; }
awaited has_folder
check "a run has a folder for /cfs" test "$(ls tmp | wc -l)" = 1
kill -KILL $child
wait $child 2>/dev/null
TMPDIR=$work/tmp "$BUILD/touchstone" run -q -m ipsc860 open >out 2>err &
awaited has_computed $! 50
kill -TERM $!
wait $!
check "the next run removes a killed one's, and its own at SIGTERM" test "$(ls tmp | wc -l)" = 0
