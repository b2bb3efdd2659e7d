#!/bin/bash
# pages.sh - the commands of pages that no other test runs do what the pages say, and print what the pages show, but for numbers:
# trace-why, profile, races, explore, surfaces, page. (Those that need gdb, a server or MPI: pages_more.sh.)
. "$(dirname "$0")/common.bash"
. "$tests/pages.bash"
ln -s "$root"/{app,bench,share,tests} .

follow profile
shows profile exact

compile ring
touchstone run -q -n 2 --trace ring.trace ring >/dev/null # any program's
follow trace-why
shows trace-why exact

follow races 3 # races were found
shows races exact

nxcc -g -O2 -o two_exchanges tests/explore/two_exchanges.c
follow explore 1 # outcomes differ
shows explore exact

# A volume as large as the scan, which does not come with touchstone: a ball with a denser core.
python3 -c '
import gzip
x = [(i - 128) ** 2 for i in range(256)]
with gzip.open("engine.raw.gz", "wb", 1) as f:
    for z in range(128):
        for y in range(256):
            d = (2 * z - 128) ** 2 + x[y]
            f.write(bytes(220 if d + v < 2500 else 120 if d + v < 10000 else 0 for v in x))'
follow surfaces
shows surfaces
for file in engine.vtk engine.obj engine.stl welded.ply; do check "surfaces: $file is written" test -s $file; done

small_paper '( 1, "1.9", 0.0, "-", "-", 1.0 ), ( 2, "1.1", 0.5, "-", "-", 0.9 ), ( 8, "0.25", 0.5, "-", "-", 0.9 )'
TOUCHSTONE_HOME=$work/home touchstone tables -o out >said 2>&1
follow page
check "page: the page is written" test -s model.html
