#!/bin/bash
# mpi.sh - programs on MPI (nxcc --mpi): handlers, floods, ends and their messages; the model finds the polygons that it finds
# on simulated nodes. mpi_nx.sh runs the conformance programs.
# without: touchstone-lab
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"

for program in interrupts masks library flood unheard ends sleeps own_mpi; do
    check "$program.c compiles" "$BUILD/nxcc" --mpi -O2 -g -Wall -o $program "$tests/mpi/$program.c" -lm
done

printed() { [ "$(cat out)" = "$1" ]; }

on_mpi 2 ./interrupts
check "a handler interrupts a computing program" printed "200 handled"
on_mpi 2 ./masks
check "masktrap holds handlers back and lets them run" printed $'masked: 0\nunmasked: 1, it was 1'
on_mpi 2 ./library
check "no handler runs inside the C library" printed "3000 handled, 0 inside"
on_mpi 3 ./flood
check "sends never wait for receives" printed "0 wrong"
on_mpi 1 ./unheard
check "a message to all others of no others keeps no memory" printed "nothing kept"

on_mpi 2 ./sleeps
check "handlers run while a node sleeps" [ "$(sort out)" = $'sleep: asleep\nslept: all of it\nusleep: asleep' ]
on_mpi 2 ./own_mpi
check "a program may have functions by the names of MPI's" printed $'102, sum 201\n102, sum 201'

for options in "-O2" "-O3 -march=native"; do
    # shellcheck disable=SC2086
    "$BUILD/nxcc" --mpi $options -Wall -o registers "$tests/../nx/registers.c" 2>compile.err
    on_mpi 2 ./registers
    check "an interrupt leaves the registers as they were: $options" printed "many rounds, 0 differ"
done

# The conformance program of long32, but for what depends on virtual time.
# MPI then sleeps while it starts, by the name that the program's own pauses have.
echo '#include <stdio.h>
#include <nx.h>
int main(void) { usleep(1000); printf("node %ld of %ld\n", mynode(), numnodes()); return 0; }' >alone.c
"$BUILD/nxcc" --mpi -O2 -w -o alone alone.c
./alone >got 2>err
check "a program runs without mpirun, too, as one node" diff got - <<<"node 0 of 1"

echo '#include <stdio.h>
#include <nx.h>
int main(void) { double begin = dclock(); for (int i = 0; i < 20000; i++) iprobe(-1); puts(dclock() - begin < 30 ? "at once" : "late"); return 0; }' >asks.c
"$BUILD/nxcc" --mpi -O2 -o asks asks.c
on_busy 2 ./asks
check "calls that need not wait leave the processor to nobody" printed $'at once\nat once'

"$BUILD/nxcc" --mpi --long32 -O2 -o long32 "$tests/../nx/long32.c"
on_mpi 3 ./long32
rules() { grep -vE '^(time|computing takes its time|a handler interrupts it):' "$1" | sort -u; }
rules out >got
rules "$tests/../nx/long32.out" >wanted
check "--long32: a program and its libraries agree" cmp got wanted

# Addresses kept in ints: of the heap, also of large blocks, of local and of static variables.
cat >kept.c <<'END'
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
int common[4];
put(at, value)
int at, value;
{
    *(int *)at = value;
}
int main(void)
{
    int local = 0, *part[] = {malloc(100), malloc(4 << 20), &local, &common[1]}, right = 0;
    for (int i = 0; i < 4; i++)
        put(part[i], mynode() + i);
    gsync();
    for (int i = 0; i < 4; i++)
        right += *part[i] == mynode() + i;
    printf("%d kept\n", right);
    return 0;
}
END
"$BUILD/nxcc" --mpi --long32 -g -w -o kept kept.c
on_mpi 2 ./kept
check "--long32: addresses kept in ints are right" printed $'4 kept\n4 kept'

# --- ends ---
sorted() { [ "$(sort out)" = "$1" ]; }
quiet() { [ "$status" = 0 ] && [ ! -s err ]; }

on_mpi 3 ./ends killcube
check "killcube ends all nodes, quietly" quiet
check "killcube: what was printed before is there" sorted $'0\n1\n2'
on_mpi 3 ./ends killproc
check "killproc ends one node" sorted $'0 lives\n2 lives'
check "killproc: quietly" quiet
on_mpi 2 ./ends returns
check "main's value is no error" quiet
check "functions of atexit run" sorted $'0 has ended\n1 has ended'
on_mpi 2 ./ends exits
check "exit's is the job's" ended_with 3
check "and told" said '^nx: node 1, at [0-9.]+ s: exit\(3\), which ends the program on all nodes'
on_mpi 3 ./ends crashes
check "a crash ends the job" [ "$status" != 0 ]
check "a crash is told with its node" said '^nx: node 2: crashed \(segmentation fault\) computing'
on_mpi 3 ./ends errs
check "an error ends the job" ended_with 1
check "an error names node, call and reason" \
    said '^nx: node 2, at [0-9.]+ s: csend\(1, buf, 80, 77, 0\): there is no node 77 \(nodes are 0 to 2; -1 is all others\)'
check "an error: what was printed before is there" sorted $'0 here\n1 here\n2 here'
"$BUILD/nxcc" --mpi -O2 -o hangs "$tests/mpi/hangs.c"
have_begun() { [ "$(wc -l <out)" = 3 ]; }
hang() {
    mpirun -np 3 ./hangs >out 2>err &
    hanging=$! signals=0
    awaited have_begun
}
hang
# Each node answers each signal. (What a node has printed is a moment before where it hangs. On a busy computer mpirun may die of
# the first signal.)
is_gone() { ! kill -0 $hanging 2>kill.err; }
answered() { is_gone || [ "$(grep -c '^nx: node [0-2]: is ' err)" -ge $((3 * signals)) ]; }
asked() {
    if is_gone; then hang; fi
    kill -USR1 $hanging && signals=$((signals + 1)) && awaited answered &&
        grep -q 'is in crecv' err && grep -q 'is computing' err && grep -q 'is after' err
}
awaited asked
kill $hanging
wait $hanging 2>wait.err
check "SIGUSR1: a program that hangs says in which call" said '^nx: node 1: is in crecv, of type or id 12'
check "SIGUSR1: or that it computes" said '^nx: node 0: is computing$'
check "SIGUSR1: or that it has ended" said "^nx: node 2: is after its program's end"
echo "some text" >text
on_mpi 2 ./ends reads <text
check "standard input is node 0's" printed "read some text"
on_mpi 1 ./ends loads
check "load says that mpirun loads" said 'load is not served on MPI: mpirun starts one program on all nodes'

# --- the driver ---
mkdir nothing
PATH=nothing "$BUILD/nxcc" --mpi -o none "$tests/mpi/masks.c" >out 2>err
status=$?
check "without mpicc: says which packages" said 'nxcc: --mpi: .*libopenmpi-dev'
"$BUILD/nxcc" --as-mpi as-mpi >out
check "nxcc's own mpicc in PATH is not MPI's" env PATH="$PWD/as-mpi:$PATH" "$BUILD/nxcc" --mpi -o own "$tests/mpi/masks.c"
check "objects are compiled apart" "$BUILD/nxcc" --mpi -O2 -c -o part.o "$tests/mpi/masks.c"
check "and linked" "$BUILD/nxcc" --mpi -o parts part.o
on_mpi 2 ./parts
check "and run" printed $'masked: 0\nunmasked: 1, it was 1'
mixed() { rm -f mixed && ! "$BUILD/nxcc" "$@" -o mixed part.o 2>err && [ ! -e mixed ] && [ "$(wc -l <err)" = 1 ]; }
check "not for simulated nodes: the object is named, in one line" eval "mixed && said '^nxcc: part.o was compiled for a cluster, with --mpi: '"
"$BUILD/nxcc" -O2 -c -o part.o "$tests/mpi/masks.c"
check "nor one of simulated nodes for a cluster" eval "mixed --mpi && said '^nxcc: part.o was compiled for simulated nodes, without --mpi: '"

# --- programs of MPI ---
begins() { echo "#include <mpi.h>
int main(void) { int begun = 0; $1 if (!begun) MPI_Init(0, 0); return 0; }" >begins.c; "$BUILD/nxcc" --mpi -o begins begins.c 2>err; }
check "a program that begins MPI is warned" eval "begins '' && said 'warning: the program calls MPI_Init, but NX begins MPI before main.*mpicc'"
check "one that asks first is not" eval "begins 'MPI_Initialized(&begun);' && ! said warning"

# --- the model ---
"$BUILD/nxcc" --mpi -O2 -o model "$tests"/../../app/*.c -lz -lm 2>compile.err
polygons() { grep -E '^polygon(s|s_by_isovalue|_digest) ' out; }
for approx in 111 333; do
    volume="-digest -approx $approx -sphere 48 40 9"
    # shellcheck disable=SC2086
    run -q -n 4 "$BUILD/app/model" $volume
    polygons >simulated
    check "$approx: there are polygons" grep -qE '^polygons [1-9]' simulated
    for how in 1 2 4 8 "8 -group 4" "4 -group 2 -preload"; do
        # shellcheck disable=SC2086
        set -- $how
        # shellcheck disable=SC2086
        on_mpi "$1" ./model "${@:2}" $volume
        polygons >real
        check "model $approx: the same polygons on $how" cmp simulated real
    done
done
