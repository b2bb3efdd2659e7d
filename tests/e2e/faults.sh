#!/bin/bash
# faults.sh - each way in which a program or its surroundings go wrong has a message, its exit status, and loses nothing that was
# printed or computed. (Others: failures.sh, wrong.sh, stopped.sh, stubs.sh, host_files.sh, resume.sh; kills at random: killed.sh.)
. "$(dirname "$0")/common.bash"
compile faults
compile ring

# --- programs ---
fault() { # HOW STATUS TEXT [TEXT...]
    local how=$1 code=$2
    shift 2
    run -q -n 2 faults "$how"
    check "$how: exit status $code" ended_with "$code"
    check "$how: what was printed before is there" grep -q 'node 1 is there,' out
    for text; do check "$how: $text" said "$text"; done
}
called='^  called from main\+0x[0-9a-f]+ \(faults.c:'
fault stack 1 'node 1 crashed .*: its stack of [0-9]+ KB overflowed' '^  in recurse.*faults.c:' '^  called from recurse.*\(faults.c:[0-9]+\), at least [0-9]+ times$' 'node.stack_kb=N gives more'
fault divide 1 'node 1 crashed .*: integer division by zero' '^  in divide.*faults.c:'
fault float_divide 1 'node 1 crashed .*: floating-point division by zero, an exception that it has unmasked' '^  in main.*faults.c:'
fault enabled_divide 1 'node 1 crashed .*: floating-point division by zero, an exception that it has unmasked' '^  in main.*faults.c:'
fault float_overflow 1 'node 1 crashed .*: floating-point overflow, an exception that it has unmasked' '^  in main.*faults.c:'
fault float_invalid 1 'node 1 crashed .*: invalid floating-point operation, an exception that it has unmasked' '^  in main.*faults.c:'
fault number 1 'node 1 crashed .*: 0x8, a member of a null pointer, or a number that is no address' '^  in printf$' '^  called from main.*faults.c:'
fault no_pointer 1 'node 1 crashed .*: 0x3ff8000000000000, a number or text used as a pointer, or one that was never set$' '^  in main.*faults.c:'
fault privileged 1 'node 1 crashed .*: it executed an instruction that programs may not .*fault.$' '^  in main.*faults.c:'
fault constant 1 'node 1 crashed .*, in its code or constants, which cannot be changed' '^  in .*faults.c:'
fault data_before 1 'node 1 crashed at or shortly before [0-9.]+ [mu]s, .*, in its code or constants, which cannot be changed' '^  in .*faults.c:'
fault stack_end 1 'node 1 crashed .*, past the end of its stack \(is an array too small' '^  called from .*faults.c:'
fault length 1 'node 1, at [0-9.]+ [mun]?s: gdsum: irecv\([0-9]+, buf, -8\): length -8 is negative' '^  called from main.*faults.c:'
check "length: lines of the library are left out" bash -c '! grep -q global.c err'
fault illegal 1 'node 1 crashed .*: illegal instruction' '^  in main.*faults.c:'
fault copy 1 'node 1 crashed .*: 0x8, a member of a null pointer, or a number that is no address$' '^  in memcpy$' '^  called from copy.*faults.c:' "$called"
fault no_function 1 'node 1 crashed .*: a null pointer$' '^  in no function: it called a pointer that leads to none$' '^  called from main.*faults.c:'
fault heap 1 'node 1, at [0-9.]+ [mun]?s: free: 0x[0-9a-f]+ .*was written past its end' '^  called from .*faults.c:'
fault heap_end 1 'node 1, at [0-9.]+ [mun]?s: its heap is damaged: .*after the 20 bytes at'
fault heap_before 1 'node 1, at [0-9.]+ [mun]?s: free: 0x[0-9a-f]+ was not allocated'
fault free_twice 1 'node 1, at [0-9.]+ [mun]?s: free: 0x[0-9a-f]+ .*is freed already' '^  called from .*faults.c:'
fault free_other 1 'node 1, at [0-9.]+ [mun]?s: free: 0x[0-9a-f]+ was not allocated' '^  called from .*faults.c:'
fault abort 1 'node 1, at [0-9.]+ [mun]?s: abort$' '^  called from .*faults.c:'
fault raise 1 'node 1, at [0-9.]+ [mun]?s: raise: signal 10 .*ends the program: it has no handler for it' '^  called from .*faults.c:'
fault caught_fault 1 'node 1 crashed .*: 0x8, a member of a null pointer' '^  in .*faults.c:'
check "a handler of SIGSEGV is not called" bash -c '! grep -q caught out'
fault handler_exit 1 'node 1 ended at [0-9.]+ [mun]?s with exit\(4\) \(faults\.c:[0-9]+\)'
check "handler_exit: the handler's output" grep -q 'the handler exits' out
fault handler_crash 1 'node 1 crashed .*: 0x8, a member of a null pointer' '^  in crashes.*faults.c:'
fault handler_jump 0
check "longjmp out of a handler: the program goes on" bash -c 'grep -q "the handler jumps" out && grep -q "and went on" out'
run -q -n 2 --max-virtual-time 2 faults handler_stays
check "a handler that was left by longjmp still holds others back: the report says so" said 'node 1: .* in a handler'
fault deadlock 2 'deadlock' 'node 1: crecv\(77\)'
check "deadlock: what all had printed" grep -q 'node 0 is there,' out

"$BUILD/touchstone" run -q -n 1 faults stdin >out 2>err <&-
status=$?
check "closed standard input is at its end" grep -q -- '-1 from stdin,and went on' out
check "closed standard input is no error" ended_with 0

cat >threads.c <<'END'
#include <pthread.h>
#include <spawn.h>
#include <unistd.h>
#include "nx.h"
static void *f(void *a) { return a; }
int main(void) { pthread_t t; pthread_create(&t, 0, f, 0); char *a[] = {"ls", 0}; execv("/bin/ls", a); vfork(); }
END
"$BUILD/nxcc" -o threads threads.c >out 2>err
status=$?
check "threads, vfork and exec are not there to link with" said 'nodes do not have execv, pthread_create, vfork: '
printf '#include "nx.h"\n__thread int own;\nint main(void) { return own; }\n' >own.c
gcc -fPIC -c own.c -I "$tests/../../nx_api/include" && "$BUILD/nxcc" -o own own.o 2>err && run -q own
check "thread-local variables of another compiler are refused" said 'nodes have no threads'

# --- readers and signals ---
mkfifo left
: <left &
exec 7>left
wait $! # the reader has gone
"$BUILD/touchstone" run -n 2 --json gone.json ring 2>err >&7
status=$?
exec 7>&-
check "a reader that is gone does not lose other results" grep -q '"virtual_time_s"' gone.json
check "and it is said" said '^touchstone run: standard output cannot be written: Broken pipe'
check "with status 74" ended_with 74
cat >chat.c <<'END'
#include <stdio.h>
#include "nx.h"
int main(void) { for (int i = 0; i < 1000000; i++) printf("%ld\n", mynode()), gsync(); }
END
"$BUILD/nxcc" -O2 -o chat chat.c
limited bash -c '"$0" run -q -n 2 chat 2>err | head -1 >out; echo ${PIPESTATUS[0]} >status' "$BUILD/touchstone"
check "run | head -1 ends as other programs do" test "$(cat status)" = 141
check "and has its line" test "$(cat out)" = 0
for signal in INT TERM; do
    env --default-signal=INT,TERM "$BUILD/touchstone" run -n 2 faults endless >out 2>err &
    child=$!
    awaited has_computed $child 60
    kill -$signal $child
    wait $child
    status=$?
    check "SIG$signal: status" ended_with $((128 + $(kill -l $signal)))
    check "SIG$signal: lines without an end are printed, too" bash -c 'grep -q "node 0 is there," out && grep -q "node 1 is there," out'
    check "SIG$signal: where the nodes are" said '^  node 1: computing.*faults.c:'
done

# --- full disks, folders that are read-only ---
full() { # OPTION
    ln -sf /dev/full full
    run -q -n 2 "$1" full ring
    check "$1 to a full disk: status 74" ended_with 74
    check "$1 to a full disk: said" said '^touchstone run: .*full.*cannot be written: No space left'
    check "$1 to a full disk: what the program printed is there" cmp out plain
}
run -q -n 2 ring
cp out plain
for option in --json --trace --history --record --deadlock --races; do full $option; done
run -q -n 32 --trace long.trace ring
cp out plain32
check "a trace of this run is longer than 4 kB" test "$(stat -c %s long.trace)" -gt 4096
rm long.trace
(
    ulimit -f 4 # of 1024 bytes
    run -q -n 32 --trace long.trace ring
    echo $status >status
)
status=$(cat status)
check "a trace that finds no room: status 74" ended_with 74
check "it is said" said 'long.trace.*cannot be written: File too large'
check "what the program printed is there" cmp out plain32
check "no half trace is left" test -z "$(find . -name 'long.trace*')"

(
    ulimit -v 500000 # of 1024 bytes
    run -n 2 ring
    echo $status >status
)
status=$(cat status)
check "less address space than nodes take: status 65" ended_with 65
check "what is allowed, how much nodes take, and how to get it is said" \
    said 'node 0: no address space left: nodes take it by 1024 MB.* ulimit -v allows 488 MB in all; ulimit -v unlimited'

if [ "$(id -u)" = 0 ] && ! setpriv --reuid=65534 --regid=65534 --clear-groups true 2>/dev/null; then
    echo "skip read-only folders: the user is root and cannot become another"
else
    user=()
    [ "$(id -u)" = 0 ] && user=(setpriv --reuid=65534 --regid=65534 --clear-groups)
    mkdir -p locked && chmod 555 locked && chmod 755 .
    "${user[@]}" "$BUILD/touchstone" run -q -n 2 --json locked/a.json "$work/ring" >out 2>err
    status=$?
    check "a read-only folder: status 74" ended_with 74
    check "a read-only folder: said" said 'locked/a.json.*cannot be written: Permission denied'
    check "a read-only folder: the program is not run for nothing" test ! -s out
    printf 'program = "ring";\nmachine = "delta";\naxes = ( { name = "nodes"; values = ( 1, 2 ); } );\n' >s.cfg
    "${user[@]}" "$BUILD/touchstone" study s.cfg -o locked/s >out 2>err
    status=$?
    check "a study in a read-only folder: status 65" ended_with 65
    check "a study in a read-only folder: said" said 'locked/s cannot be made: Permission denied'
    mkdir open && chmod 777 open
    "${user[@]}" env -u XDG_CACHE_HOME HOME="$work/locked" "$BUILD/touchstone" study s.cfg -o open/s >out 2>err
    status=$?
    check "a study whose user has a read-only home: status 0" ended_with 0
    check "it is said once" test "$(grep -c 'not added to the result cache: .*/locked/.* cannot be made: Permission denied' err)" = 1
fi

# --- what is not there ---
printf 'program = "ring";\nmachine = "delta";\naxes = ( { name = "nodes"; values = ( 1, 2 ); } );\n' >s.cfg
mkdir bin
env -u HOME -u XDG_CACHE_HOME PATH="$work/bin" "$BUILD/touchstone" study s.cfg -o s >out 2>err </dev/null
status=$?
check "no HOME, no gnuplot: the results are there" grep -q '^nodes' s/results.csv
check "no gnuplot: said once, with the package" test "$(grep -c '^no pictures: .*gnuplot.*: apt install gnuplot-nox' err)" = 1
check "no gnuplot: status 1" ended_with 1
PATH="$work/bin" "$BUILD/touchstone" plot s >out 2>err </dev/null
status=$?
check "no gnuplot, plot: said" said '^touchstone plot: .*: apt install gnuplot-nox$'
check "no gnuplot, plot: status 1" ended_with 1
sed 's/^axes/pictures = ( );\naxes/' s.cfg >none.cfg
PATH="$work/bin" "$BUILD/touchstone" study none.cfg -o none >out 2>err </dev/null
status=$?
check "no gnuplot: no error, if the study wants no picture" ended_with 0
sed 's/^axes/pictures = ( { file = "t"; x = "nodes"; y = "total_s"; } );\naxes/' s.cfg >p.cfg
PATH="$work/bin" "$BUILD/touchstone" study p.cfg -o p --no-cache >out 2>err </dev/null
status=$?
check "no gnuplot: status 1, if it asks for one" ended_with 1
check "no gnuplot: the results are there, too" grep -q '^nodes' p/results.csv

# --- clocks: only the host's monotonic clock measures ---
check "no file of the simulator measures by the clock that people set" \
    bash -c '! grep -rnE "CLOCK_REALTIME|gettimeofday\(" "$0"/../../sim --include=*.c | grep -v "sim/guest/\|clock_gettime(CLOCK_REALTIME_COARSE"' "$tests"

# --- short messages find room whatever a node's memory is ---
cat >flood.c <<'E'
#include <nx.h>
int main(void)
{
    char text[100] = "";
    for (long i = 0; mynode() == 0 && i < 200000; i++)
        csend(1, text, sizeof text, 1, 0);
    return 0;
}
E
"$BUILD/nxcc" -O2 -o flood flood.c
run -n 2 flood
check "a node that is flooded: the summary says what is beyond its memory" \
    said '^memory +[0-9.]+ MB at most \(node 1\), of 14.50 MB for programs; short messages that nobody received took the rest'
