#!/bin/bash
# quiet.sh - programs with handlers armed that say, in loops, how long they will make no call, are let off until then; that
# changes nothing. The same program that counts in memory says nothing: same times, digest, and outcome, also if messages
# of all kinds come in between, programs are killed or fail, time is limited, with any slices and several threads.
# The line where a program was seen computing last differs: the two look at their clocks in other places.
. "$(dirname "$0")/common.bash"

"$BUILD/nxcc" -O2 -o quiet "$tests/quiet.c"
"$BUILD/nxcc" -O2 -fplugin-arg-count-memory -o silent "$tests/quiet.c"

# All that a run gives, without its wall times, and the memory and addresses, which are the larger program's.
results() { # PROGRAM ARGS...
    local program=$1
    shift
    rm -f f.json
    "$BUILD/touchstone" run --max-wall-time 60 --json f.json "${options[@]}" "$program" "$@" >out 2>err </dev/null
    { echo "status $?" && cat out && grep -v '^wall time\|^memory' err && grep -v 'wall_time\|memory_\|"program"' f.json; } |
        sed 's/main+0x[0-9a-f]*/main/; s/computing (quiet.c:[0-9]*)/computing/g'
}

for seed in 1 2 3 4; do
    for how in "" kill fail crash limit; do
        machine=(-n $((3 + 2 * seed)))
        [ "$how" != limit ] || machine+=(--max-virtual-time "0.0$seed")
        options=("${machine[@]}" -w 1)
        results silent $seed $how | sed 's/silent/quiet/' >one
        for way in "-w 1" "-w 3 --shuffle $seed" "-w 2 --slice 0.00005"; do
            # shellcheck disable=SC2206
            options=("${machine[@]}" $way)
            results quiet $seed $how >other
            check "seed $seed $how: $way" diff one other
        done
    done
done
