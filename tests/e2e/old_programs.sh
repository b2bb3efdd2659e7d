#!/bin/bash
# old_programs.sh - what doc/old-programs.md shows: its example, and what is said when it goes wrong.
. "$(dirname "$0")/common.bash"

example "$tests/../../doc/old-programs.md" pi.c

build() { "$BUILD/nxcc" -w -O2 "$@"; }
check "without --long32 it does too" build -o pi pi.c
for machine in "ipsc860 -n 1" "ipsc860 -n 2" "delta -n 33" "paragon -n 8"; do
    # shellcheck disable=SC2086
    run -m $machine pi
    check "on $machine" grep -qx 'pi is 3.1415926536; a long has 8 bytes' out
done

sed 's/&sum, sizeof sum, -1/\&sum, 2 * sizeof sum, -1/' pi.c >long.c
check "with a message too long it compiles" build -o long long.c
run -m ipsc860 -n 3 long
check "the error names call and arguments" said 'node [12], at 0\.[0-9]* s: crecv\(2, buf, 8\): the message of type 2 from node 0 has 16'
check "and its line" said "called from main.*\(long\.c:$(grep -n 'crecv(DONE' long.c | cut -d: -f1)\)"

sed 's/crecv(DONE/crecv(DONE + 1/' pi.c >hangs.c
check "with a wrong type it compiles" build -o hangs hangs.c
run -m ipsc860 -n 3 hangs
check "a deadlock is explained" said "^  node 1: crecv\(3\) since 0\..* s \(hangs\.c:$(grep -n 'crecv(DONE' hangs.c | cut -d: -f1)\)"
check "exit status 2" ended_with 2
