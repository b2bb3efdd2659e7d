#!/bin/bash
# exact.sh - a program on a machine gives the same digest and times in every run, and in other builds of the simulator
# (with less optimisation, with sanitizers).
. "$(dirname "$0")/common.bash"
compile ring

# Prints the output and figures of a run, without wall times.
figures() { # TOUCHSTONE ARGS...
    local touchstone=$1
    shift
    rm -f f.json
    "$touchstone" run -q --json f.json "$@" >out 2>err && cat out && grep -v wall_time f.json
}

same() { # NAME ARGS...
    local name=$1
    shift
    figures "$BUILD/touchstone" "$@" >first
    check "$name: it runs" grep -q '"digest": "[0-9a-f]*[1-9a-f]' first
    figures "$BUILD/touchstone" "$@" >again
    check "$name: twice the same" cmp first again
    for other in light asan; do
        if [ -x "$BUILD/$other/touchstone" ]; then
            figures "$BUILD/$other/touchstone" "$@" >other
            check "$name: the same in the build $other" cmp first other
        else
            echo "skip $name: there is no build $other"
        fi
    done
}
same "ring on a mesh" -m delta -n 6 ring
same "ring on a cube" -m ipsc860 -n 8 ring
same "the model program" -n 8 "$BUILD/app/model" -sphere 64 64 9 -group 4
same "the model program, (3,3,3)" -n 8 "$BUILD/app/model" -approx 333 -sphere 32 32 9 -group 4
