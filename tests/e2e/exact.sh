#!/bin/bash
# exact.sh - the same program on the same machine gives the same digest and times: again, and in another build.
. "$(dirname "$0")/common.bash"
compile ring

# The run without its wall times.
figures() { # TOUCHSTONE ARGS...
    local touchstone=$1
    shift
    rm -f f.json
    "$touchstone" run -q --json f.json "$@" >out 2>err && cat out && grep -v wall_time f.json
}
for on in "-m delta -n 6" "-m ipsc860 -n 8"; do
    # shellcheck disable=SC2086
    figures "$BUILD/touchstone" $on ring >first
    check "ring $on: it runs" grep -q '"digest": "[0-9a-f]*[1-9a-f]' first
    # shellcheck disable=SC2086
    figures "$BUILD/touchstone" $on ring >again
    check "ring $on: twice the same" cmp first again
    if [ -x "$BUILD/O0/touchstone" ]; then
        # shellcheck disable=SC2086
        figures "$BUILD/O0/touchstone" $on ring >other
        check "ring $on: the same when the simulator is compiled without optimisation" cmp first other
    else
        echo "skip ring $on: there is no build/O0"
    fi
done
figures "$BUILD/touchstone" -n 8 "$BUILD/app/model" -sphere 64 64 9 -group 4 >first
figures "$BUILD/touchstone" -n 8 "$BUILD/app/model" -sphere 64 64 9 -group 4 >again
check "the model program: it runs" grep -q '"digest": "[0-9a-f]*[1-9a-f]' first
check "the model program: twice the same" cmp first again
[ ! -x "$BUILD/O0/touchstone" ] || {
    figures "$BUILD/O0/touchstone" -n 8 "$BUILD/app/model" -sphere 64 64 9 -group 4 >other
    check "the model program: the same when the simulator is compiled without optimisation" cmp first other
}
