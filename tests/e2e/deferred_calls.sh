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

# Times of deferred calls are noted with 56 bits: the program runs before, at and after 2^56 ps.
for later in 72057560000 72057590000 72057600000; do
    run_results -w 1 -n 7 flushing 3 6 $later | sed 's/flushing/talk/' >one
    run_results -w 1 -n 7 talk 3 6 $later >other
    check "after $later us" diff one other
done
