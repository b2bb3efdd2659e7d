#!/bin/bash
# model.sh - the model program's polygons are the same however the work is divided.
. "$(dirname "$0")/common.bash"

# The polygons of a run: their numbers and the hash of all their vertices.
polygons() { # NODES ARGS...
    local nodes=$1
    shift
    run -q -n "$nodes" "$BUILD/app/model" -digest "$@"
    grep -E '^polygon(s|s_by_isovalue|_digest) ' out
}
for approx in 111 333; do
    volume="-approx $approx -sphere 48 40 9"
    # shellcheck disable=SC2086
    polygons 1 $volume >alone
    check "$approx: there are polygons" grep -qE '^polygons [1-9]' alone
    for how in "2 -group 2" "4 -group 4" "8 -group 8" "8 -group 4" "8 -group 2" "8 -group 2 -noreassign" "4 -group 2 -preload"; do
        # shellcheck disable=SC2086
        polygons $how $volume >shared
        check "$approx: $how as alone" cmp alone shared
    done
done

# A CT scan of an engine block, if it is at hand.
scan=$tests/../../../shared/data/engine_256x256x128_uint8.raw.gz
if [ -r "$scan" ]; then
    cp "$scan" engine.raw.gz
    for n in 1 16; do
        polygons $n -volume engine.raw.gz 256 256 128 8 -isovalues 80,160 >scan.$n
    done
    check "a scan: there are polygons" grep -qE '^polygons [1-9]' scan.1
    check "a scan: the same on 1 node and 16" cmp scan.1 scan.16
else
    echo "skip a scan: no engine block beside the checkout"
fi
