#!/bin/bash
# races_cost.sh - a program built with nxcc --races takes the same virtual time as without, to the picosecond, and prints the
# same: the programs of tests/nx, Fortran programs, and app/.
. "$(dirname "$0")/common.bash"

# What a run gives but for races found, its memory and wall times.
results() { # ARGS...
    limited "${touchstone:-$BUILD/touchstone}" run --max-wall-time $((patience / 2)) "$@" >out 2>err </dev/null
    status=$?
    grep -q '^virtual time' err || { echo "cannot be run: $RANDOM$RANDOM" && cat err; }
    cat out && grep -E '^(virtual time|messages|nodes|interrupts|digest)' err
}

# The same results with and without --races, at an optimisation level, of the program that NAME is made of by nxcc LEVEL ARGS.
same() { # NAME "RUN ARGS" LEVEL NXCC ARGS...
    local name=$1 arguments=$2
    shift 2
    mkdir -p races plain # (a program may ask for its folder: names of one length)
    compiled_once "plain/$name" nxcc "$@" -lm 2>compile.err && "$BUILD/nxcc" --races "$@" -o "races/$name" -lm 2>compile.err ||
        { echo "not ok $name compiles" && cat compile.err && return; }
    # shellcheck disable=SC2086
    (cd plain && results ${arguments/PROGRAM/$name}) >one
    # shellcheck disable=SC2086
    (cd races && results ${arguments/PROGRAM/$name}) >other
    check "$name $1: the same times" diff one other
}

for source in "$tests"/../nx/*.c; do
    options=$(sed -n 's/^ \* compile: //p' "$source")
    # shellcheck disable=SC2086
    same "$(basename "$source" .c)" "$(first_run "$source") PROGRAM" -O2 -g $options "$(whole "$source")" # (as compile_rule)
done
for source in "$tests"/../nx/*.f; do
    arguments=$(sed -n 's/^[cC!*] run: //p' "$source" | head -1 | sed 's/^all$/-m delta -n 8/')
    same "$(basename "$source" .f)" "$arguments PROGRAM" -O2 "$source"
done

# At other levels, and combined with what changes code most.
for options in -O0 -O1 -O3 --profile --long32; do
    # shellcheck disable=SC2086
    same talk "-n 7 PROGRAM 3 6" $options "$tests/talk.c"
    # shellcheck disable=SC2086
    same private "-n 3 PROGRAM" $options "$tests/fortran/private.f"
done

# A part of a program may be built without: it tells nothing.
"$BUILD/nxcc" -c "$tests/parts.c" && "$BUILD/nxcc" --races -c "$tests/talk.c" && "$BUILD/nxcc" -o linked talk.o
check "linked without --races, an object built with it brings what it needs" eval 'nm linked | grep -q nxc_race_tell && ! nm parts.o | grep -q nxc_race'

app=("$tests"/../../app/*.c)
same model "-n 8 PROGRAM -digest -grid 2 -sphere 24 20 16" -O2 "${app[@]}" -lz --factors "$tests/../../bench/paper/fitted.cfg"
# (Many functions of times.c use one static variable, whose address nobody takes.)
same model_times "-m delta -n 32 PROGRAM -sphere 64 64 17 -group 8 -times" -O2 "${app[@]}" -lz --factors "$tests/../../bench/paper/fitted.cfg"
