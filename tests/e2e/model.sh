#!/bin/bash
# model.sh - the model program finds the same polygons, however its work is divided.
# without: touchstone-lab
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
    for how in "2 -group 2" "4 -group 4" "8 -group 8" "8 -group 4" "8 -group 2" "8 -group 2 -noreassign" "4 -group 2 -preload" \
        "8 -group 4 -shares layers -weights exact" "8 -group 4 -noempty -nooverlap -keep 20" "8 -group 4 -prepare once -buffers 1" \
        "8 -group 4 -prepare subcube -k 0.7 -minrows 3"; do
        # shellcheck disable=SC2086
        polygons $how $volume >shared
        check "$approx: $how as alone" cmp alone shared
    done
done

# A volume in a file: plain, compressed, in two compressed members, and each of them on the Concurrent File System.
awk 'BEGIN { for (z = 0; z < 6; z++) for (y = 0; y < 32; y++) for (x = 0; x < 40; x++)
    printf "%c", 33 + int((x + 2 * y + 5 * z + x * y / 16) % 90) }' >volume.raw
gzip -c volume.raw >volume.gz
{ head -c 3000 volume.raw | gzip -c; tail -c +3001 volume.raw | gzip -c; } >volume2.gz
mkdir cfs
cp volume.raw volume.gz cfs
polygons 4 -volume volume.raw 40 32 6 8 -isovalues 60.5 >plain
check "a file: there are polygons" grep -qE '^polygons [1-9]' plain
for file in volume.gz volume2.gz; do
    polygons 4 -volume $file 40 32 6 8 -isovalues 60.5 >packed
    check "a file: $file as plain" cmp plain packed
done
for file in volume.raw volume.gz; do
    run -q --cfs cfs -n 4 "$BUILD/app/model" -digest -volume /cfs/$file 40 32 6 8 -isovalues 60.5
    grep -E '^polygon(s|s_by_isovalue|_digest) ' out >onfs
    check "a file: /cfs/$file as plain" cmp plain onfs
done
head -c 7000 volume.raw >short.raw
run -q -n 2 "$BUILD/app/model" -volume short.raw 40 32 6 8
check "a file that ends too soon is an error that names it" grep -q 'short.raw holds less than 40 x 32 x 6 pixels of 8 bits' err
gzip -c short.raw >short.gz
{ cat volume.raw; echo; } >long.raw
gzip -c long.raw >long.gz
for file in short.gz long.raw long.gz; do
    run -q -n 2 "$BUILD/app/model" -volume $file 40 32 6 8
    check "$file: an error at the start" grep -q "$file holds [a-z]* than 40 x 32 x 6 pixels" err
    check "$file: nothing is computed" test ! -s out
done

# The paper's own size of images, at a grid of three pixels, on nodes of 16 MB.
run -q -n 2 "$BUILD/app/model" -approx 333 -grid 3 -sphere 512 768 4
check "512 x 768 pixels of C3 data on two nodes" grep -qE '^polygons [1-9]' out

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
