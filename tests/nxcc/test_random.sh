#!/bin/bash
# Random programs, each compiled by nxcc at three levels, print what gcc's print. What they count depends neither on how often they are
# preempted, nor on whether the counter is in a register or in memory, nor on --profile, whose sum over the functions is the
# same. No call comes before the end of the lookahead (report.c). Preemptions come at the same times, although no loop is
# pre-charged where the counter is in memory.
set -u
cd "$(dirname "$0")" || exit 1
NXCC=../../nxcc
DIR=$(mktemp -d)
trap 'rm -rf "$DIR"' EXIT
WARN=-w

# computing SECONDS COMMAND: what takes more of a processor's time than any such program hangs
computing() { (ulimit -t "$1" && shift && exec "$@"); }

# build NAME OPTIONS... - counted program $DIR/NAME from $DIR/p.c
build() {
    local name=$1
    shift
    "$NXCC" $WARN "$@" -c -o "$DIR/$name.o" "$DIR/p.c" &&
        gcc -o "$DIR/$name" "$DIR/$name.o" counter.o report.o hosted.o -lm
}

# preempted NAME BUDGET - the program NAME prints and counts as ever when it is preempted; $DIR/NAME.BUDGET says when
preempted() {
    BUDGET=$2 computing 60 "$DIR/$1" 2>"$DIR/$1.$2" | cmp -s - "$DIR/expected" &&
        grep -v ' preemptions, ' "$DIR/$1.$2" | cmp -s - "$DIR/units" || { echo "# seed $seed $level $1 budget $2: differs"; return 1; }
}

one() {
    local seed=$1 level budget other="--profile" levels=(-O0 -O2 -Os)
    [ $((seed % 2)) = 0 ] || other="--profile -fplugin-arg-count-memory"
    [ $((seed / 2 % 2)) = 0 ] || levels=(-O1 -O2 -O3)
    ./random "$seed" >"$DIR/p.c"
    gcc $WARN -O1 -ffp-contract=off -o "$DIR/plain" "$DIR/p.c" -lm || return 1
    computing 20 "$DIR/plain" >"$DIR/expected" || { echo "# seed $seed: plain program fails"; return 1; }
    for level in "${levels[@]}"; do
        # shellcheck disable=SC2086
        build counted $level && build other $level $other || return 1
        computing 60 "$DIR/counted" >"$DIR/said" 2>"$DIR/units"
        cmp -s "$DIR/said" "$DIR/expected" || { echo "# seed $seed $level: other output"; return 1; }
        computing 60 "$DIR/other" 2>"$DIR/units2" | cmp -s - "$DIR/expected" || { echo "# seed $seed $level $other: other output"; return 1; }
        cmp -s "$DIR/units" "$DIR/units2" || { echo "# seed $seed $level $other: counts differently"; return 1; }
        for budget in 5000 777777; do
            preempted counted "$budget" && preempted other "$budget" || return 1
            cmp -s "$DIR/counted.$budget" "$DIR/other.$budget" ||
                { echo "# seed $seed $level $other budget $budget: preempted at other times"; return 1; }
        done
    done
}

failed=0
for seed in $(seq "${FIRST:-1}" "${LAST:-12}"); do
    one "$seed" || { failed=1; break; }
done
[ $failed = 0 ] && echo "ok random programs count alike at every budget, and compute what gcc's do" ||
    echo "not ok random programs count alike at every budget, and compute what gcc's do"
exit $failed
