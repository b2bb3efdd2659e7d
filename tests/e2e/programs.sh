#!/bin/bash
# programs.sh - several programs in one run: run -n 1 PROGRAM : -n 4 OTHER.
# without: app
. "$(dirname "$0")/common.bash"

# One source: the master hands out numbers, slaves give back their squares. NX's calls, or MPI's.
cat >part.c <<'END'
#include <stdio.h>
#include <string.h>
#ifdef MPI
#include <mpi.h>
#else
#include "nx.h"
#endif
#ifndef FACTOR
#define FACTOR 1
#endif
int main(int argc, char **argv)
{
    long n, rank;
#ifdef MPI
    int r, size, found, *program;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &r);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    MPI_Comm_get_attr(MPI_COMM_WORLD, MPI_APPNUM, &program, &found);
    rank = r, n = found ? *program : -1;
    MPI_Reduce(r ? (void *)&n : MPI_IN_PLACE, &n, 1, MPI_LONG, MPI_SUM, 0, MPI_COMM_WORLD);
    MPI_Finalize();
    if (!rank)
        printf("%s: %d ranks, sum of programs %ld\n", argv[1], size, n);
#elif defined MASTER
    long got, sum = 0;
    for (n = 1; n < numnodes(); n++)
        csend(1, &n, sizeof n, n, 0);
    for (n = 1; n < numnodes(); n++)
        crecv(2, &got, sizeof got), sum += got;
    printf("master of %d words: %ld\n", argc, sum);
    rank = sum;
#else
    rank = mynode();
    crecv(1, &n, sizeof n);
    n *= n * FACTOR;
    csend(2, &n, sizeof n, 0, 0);
    printf("%s on %ld: %d words, last %s\n", argv[0], rank, argc, argv[argc - 1]);
#endif
    return 0;
}
END
nxcc() { "$BUILD/nxcc" -g -O2 "$@" part.c 2>compile.err; }
check "programs compile" eval 'nxcc -DMASTER -o master && nxcc -o slave && nxcc -DMPI -lmpi -o one && nxcc -DMPI -DFACTOR=2 -lmpi -o two'

run -q -n 1 master : -n 2 ./slave a : -np 1 ./slave b c
check "each program has its nodes, in order, and its arguments" cmp <(sort out) - <<'END'
./slave on 1: 2 words, last a
./slave on 2: 2 words, last a
./slave on 3: 3 words, last c
master of 1 words: 14
END
equal_results "programs" -m paragon -n 1 master : -n 2 ./slave a : -n 1 ./slave b c
run -q -n 2 one first : -n 3 two
check "MPI: one world; MPI_APPNUM tells the programs apart" test "$status:$(cat out)" = "0:first: 5 ranks, sum of programs 3"
run -q -n 1 slave : -x
check "a colon without -n is the program's" said 'crecv'
run -q -n 1 one : -n
check "so is an -n without a program" grep -q '^:: 1 ranks' out
run -q -n 1 master : -n 0 ./slave
check "0 nodes: an error" said '-n takes a number of nodes, 1 or more, not .0'
run -q -n 1 master : -n 4294967295 ./slave
check "more nodes than there can be" said 'more nodes than a machine can have'
run -q -n 1 master : -n 1 ./none
check "a program that is not there" said 'there is no program ./none'
run -q -n 1 --host master slave : -n 1 slave
check "not with --host" said 'HOST loads the nodes'
printf '#include "nx.h"\nint main(void) { long x; crecv(3, &x, 8); return 0; }\n' >waits.c
sed 's/crecv/if (mynode() < 0) csend(1, \&x, 8, myhost(), 0); &/' waits.c >knows.c
"$BUILD/nxcc" -O2 -o waits waits.c && "$BUILD/nxcc" -O2 -o knows knows.c
run -q -m ipsc860 -n 2 waits : -n 1 knows
check "a program that knows of a host, wherever it is, may lack it" said '^    A node has to send first, or a host program'
run -q --profile p -n 1 master : -n 1 slave
check "no profile of several programs" said 'profile is for one program'

costs=$tests/../../machines/cpu
"$BUILD/nxcc" -O2 --costs "$costs/i860xp-cache.cfg" -o other part.c
run -n 1 master : -n 1 other : -n 1 other
check "other costs of a program that is there twice: said once" test "$(grep -c 'was compiled with the costs of' err)" = 1
run -q -n 1 --record plan master : -n 2 ./slave : -n 1 ./slave
run -q -n 1 --replay plan master : -n 2 ./slave : -n 1 ./slave
check "a schedule replayed" test ! -s err
run -q -n 1 --replay plan master : -n 1 ./slave : -n 2 ./slave
check "a schedule knows which nodes have which program" said 'was recorded of another program'
run -q -n 1 --record plan master : -n 2 ./slave
nxcc -DFACTOR=3 -o slave
run -q -n 1 --replay plan master : -n 2 ./slave
check "a schedule knows each program" said 'was recorded of another program'

explored() { "$BUILD/touchstone" explore --runs 4 -o ex -n 1 "$@" >out 2>err </dev/null; }
explored master : -n 2 ./slave
check "explore" grep -q '4 runs made' out
explored master : -n 2 ./slave
check "explore again: nothing to be done" grep -q 'no run made: all 4 ' out
nxcc -DFACTOR=2 -o slave
explored master : -n 2 ./slave
check "explore: another second program is another" grep -q '4 runs made' out

run -q --trace trace -n 1 master : -n 2 ./slave
"$BUILD/touchstone" trace why --rerun trace >out 2>err
check "a trace is made again, of all programs" grep -q '^master took .* on 3 nodes' out
