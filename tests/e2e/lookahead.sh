#!/bin/bash
# lookahead.sh - lookahead changes no result. Programs whose loops give lookahead are offloaded while handlers are posted. The
# program that counts in memory gives none: times, digest and outcome must be equal, also if messages of all kinds come
# meanwhile, if programs are killed or fail, if time is limited, with any slices and several workers.
# The line where a program was last seen computing differs, since the two programs poll at different places.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"

"$BUILD/nxcc" -O2 -o lookahead "$tests/lookahead.c"
"$BUILD/nxcc" -O2 -fplugin-arg-count-memory -o none "$tests/lookahead.c"

# Prints all results of a run but wall times, memory and addresses; the last two are those of the larger program.
results() { # PROGRAM ARGS...
    local program=$1
    shift
    rm -f f.json
    "$BUILD/touchstone" run --max-wall-time "$patience" --json f.json "${options[@]}" "$program" "$@" >out 2>err </dev/null
    { echo "status $?" && cat out && grep -v '^wall time\|^memory' err && grep -v 'wall_time\|memory_\|"program"' f.json; } |
        sed 's/main+0x[0-9a-f]*/main/; s/computing (lookahead.c:[0-9]*)/computing/g'
}

for seed in 1 2 3 4; do
    for how in "" kill fail crash limit; do
        machine=(-n $((3 + 2 * seed)))
        [ "$how" != limit ] || machine+=(--max-virtual-time "0.0$seed")
        options=("${machine[@]}" -w 1)
        results none $seed $how | sed 's/\bnone\b/lookahead/' >one
        for way in "-w 1" "-w 3 --shuffle $seed" "-w 2 --slice 0.00005"; do
            # shellcheck disable=SC2206
            options=("${machine[@]}" $way)
            results lookahead $seed $how >other
            check "seed $seed $how: $way" diff one other
        done
    done
done
