#!/bin/bash
# cache.sh - a program compiled with a data cache (i860xr-cache.cfg): 8 KB, lines of 32 bytes, 11 clocks for a line that is
# not there, 3 for a store to one.
. "$(dirname "$0")/common.bash"
compile cache
"$BUILD/nxcc" -O2 --costs i860xr-cache.cfg -o cached "$tests/cache.c"

# What the cache adds to PASS over N elements, in clocks.
adds() {
    run -m ipsc860 -q cache "$2"
    local without
    without=$(sed -n "s/^$1 //p" out)
    run -m ipsc860 -q cached "$2"
    echo $(($(sed -n "s/^$1 //p" out) - without))
}
near() { [ $(($1 - $2)) -le 40 ] && [ $(($2 - $1)) -le 40 ]; }

check "a small field misses once a line" near "$(adds first 512)" $((11 * 128))
check "a small field is there the second time" near "$(adds again 512)" 0
check "a large field misses once a line" near "$(adds first 8192)" $((11 * 2048))
check "a large field misses again" near "$(adds again 8192)" $((11 * 2048))
check "stores to what is there cost nothing" near "$(adds write 512)" 0
check "stores to what is not there cost 3 each and bring nothing in" near "$(adds write 65536)" $((3 * (65536 - 1024)))

sed 's/ways = 2/ways = 3/' "$tests/../../machines/cpu/i860xr-cache.cfg" >three.cfg
cp "$tests/../../machines/cpu/i860-calls.cfg" .
"$BUILD/nxcc" --costs ./three.cfg -c "$tests/cache.c" >out 2>err
status=$?
check "a cache of three ways is refused" said "three.cfg:[0-9]+: cache: 'ways' must be a power of two"
