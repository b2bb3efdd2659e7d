#!/bin/bash
# deferred_calls.sh - deferring calls changes no result. A program that has flushmsg defers no call: its times, digest and
# outcome must equal those of the program without flushmsg, on all machines, with any number of workers, and with a limit of
# virtual time.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"

"$BUILD/nxcc" -O2 -o talk "$tests/talk.c"
"$BUILD/nxcc" -O2 -DFLUSHES -o flushing "$tests/talk.c"

for seed in 1 2 3 4 5 6; do
    for machine in "delta -n $((1 + 2 * seed))" "ipsc860 -n $((1 << (seed % 3 + 1)))" "paragon -n 5" "delta -n 4 --max-virtual-time 0.0$seed"; do
        # shellcheck disable=SC2086
        run_results -w 1 -m $machine flushing $seed 6 | sed 's/flushing/talk/' >one
        for way in "-w 1" "-w 3 --shuffle $seed --slice 0.0001"; do
            # shellcheck disable=SC2086
            run_results $way -m $machine talk $seed 6 >other
            check "seed $seed, $machine: $way" diff one other
        done
    done
done

# Times of deferred calls are noted with 56 bits, of which one is for the call's own time: the program runs before, at and
# after 2^55 and 2^56 ps.
for later in 36028760000 36028790000 36028800000 72057560000 72057590000 72057600000; do
    run_results -w 1 -n 7 flushing 3 6 $later | sed 's/flushing/talk/' >one
    run_results -w 1 -n 7 talk 3 6 $later >other
    check "after $later us" diff one other
done

# A call may last from before 2^56 ps to after: one does in these runs, which come there so many ns before 2^56 ps.
cat >across.c <<'E'
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>
int main(int argc, char **argv)
{
    static char in[1500], out[1500];
    long me = mynode(), n = numnodes(), next = (me + 1) % n, before = (me + n - 1) % n;
    gsync();
    sleep(72057);
    double sum = 0;
    long left = (long)((72057.594037927936 - dclock()) * 1e9) - atol(argv[1]);
    nanosleep(&(struct timespec){0, left + me * 37}, NULL);
    for (int i = 0; i < 60; i++) {
        long id = irecv(i, in, sizeof in);
        csend(i, out, i * 37 % 1500, next, 0);
        for (volatile int k = 0; k < (me * 13 + i * 7) % 40; k++)
            ;
        msgwait(id);
        if (i % 3 == 0) {
            csend(100 + i, out, 4, next, 0), csend(200 + i, out, 4, before, 0);
            crecv(100 + i, in, 4), crecv(200 + i, in, 4);
        }
        sum += dclock();
    }
    printf("%.9f\n", sum);
    return argc - 2;
}
E
"$BUILD/nxcc" -O1 -o across across.c
for before in 792462 5775367 10422076 16413569; do
    run_results -n 5 --engine reference across $before >one
    run_results -w 1 -n 5 across $before >other
    check "calls across 2^56 ps, $before ns" diff one other
done
