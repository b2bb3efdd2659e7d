#!/bin/bash
# apart.sh - a node that accesses other memory than its own is stopped; the message names node and line; other nodes' memory is
# unchanged.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
compile apart

stopped() { # NAME WHAT ARGS...
    local name=$1 what=$2
    shift 2
    run -q -n 4 "$@"
    check "$name: node 3 is stopped" said "touchstone run: node 3.*$what"
    check "$name: status 1" ended_with 1
}
at_line() { check "$1: with function and line" said "(in|called from) $2.*apart.c:"; }
stopped "a frame larger than the stack" 'stack of 512 KB overflowed' apart frame
at_line "a frame larger than the stack" large_frame
stopped "an array larger than the stack" 'stack of 512 KB overflowed' apart array 1000000
at_line "an array larger than the stack" any_frame
stopped "an array larger than many stacks" 'stack of 512 KB overflowed' apart array 100000000
stopped "over the end of the heap" 'past the end of its heap' apart heap
at_line "over the end of the heap" 'overrun|main'
stopped "over the end of static data" 'past the end of its static data' apart data
for way in behind head before; do
    stopped "writing $way a block, found at the end" 'its heap is damaged: .* before or after the 1[0-9]+ bytes' apart $way
done
stopped "writing behind a block, found by free" 'free: .* written past its end' apart free
stopped "writing behind a block, found by realloc" 'realloc: .* written past its end' apart realloc

run -q -n 3 --isolate apart other
check "to another's memory: read, not written" grep -q '^read 0' out
check "to another's memory: whose it is" said 'touchstone run: node 1 crashed .* in the memory of node 0'
at_line "to another's memory" 'write_to_other|main'
run -q -n 4 --isolate apart near
check "--isolate changes nothing else" ended_with 0

run -q -n 3 apart stacks
check "calls from stacks in heap and data" ended_with 0
check "and what they answer" diff - <(sort out) <<END
node 0 of 3: 0, 1, 0.0
node 0 of 3: 0, 1, 0.0
node 1 of 3: 1, 1, 0.0
node 1 of 3: 1, 1, 0.0
node 2 of 3: 2, 1, 0.0
node 2 of 3: 2, 1, 0.0
END
run -q -n 40 apart addresses
cp out first
for engine in fast reference; do
    run -q -n 40 --engine $engine apart addresses
    check "the same addresses in every run: $engine" cmp first out
done
for machine in delta paragon cluster2026; do
    run -q -m $machine -n 3 apart near
    check "stack, data and heap within 2 GB on $machine" diff - out <<<$'1\n1\n1'
done
case $BUILD in
*asan*) echo "skip memory below 4 GB, which AddressSanitizer needs" ;;
*)
    "$BUILD/nxcc" -O2 --long32 -o low "$tests/apart.c" 2>compile.err
    run -q -m delta -n 3 low low
    check "below 4 GB with a long of 32 bits" diff - out <<<$'1\n1\n1'
    ;;
esac
