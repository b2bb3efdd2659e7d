#!/bin/bash
# old_style.sh - C of 1990 compiles without options, and runs.
. "$(dirname "$0")/common.bash"

old() { "$BUILD/nxcc" -w -O2 -o old "$tests/old_style.c" "$tests/old_style_part.c"; }
old89() { "$BUILD/nxcc" -std=gnu89 -w -O2 -o old "$tests/old_style.c" "$tests/old_style_part.c"; }
old32() { "$BUILD/nxcc" --long32 -w -O2 -o old "$tests/old_style.c" "$tests/old_style_part.c"; }
check "old style: as gnu89 too, and with --long32" eval "old89 && old32"
check "old style: two files with common variables, without prototypes" old

for machine in "ipsc860 -n 2" "ipsc860 -n 8" "delta -n 33"; do
    # shellcheck disable=SC2086
    run -m $machine old
    check "old style on $machine: it ends well" ended_with 0
    for ((i = 0, n = ${machine##* }; i < n; i++)); do
        echo "node $(((i + 1) % n)): type $((20 + (i + 1) % n)), $i bytes from $i"
    done | sort >expected
    check "old style on $machine: one handler a node" diff expected <(sort out)
done

strict() { ! "$BUILD/nxcc" -w -o old "$tests/missing.c"; }
check "old style: a call that is not there is still named when it is linked" strict
named() { "$BUILD/nxcc" -w -o old "$tests/missing.c" 2>&1 | grep "missing\.c:6: undefined reference to .gfrobnicate"; }
check "old style: with its file and line" named
