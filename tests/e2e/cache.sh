#!/bin/bash
# cache.sh - a program compiled with a data cache (i860xr-cache.cfg): 8 KB, lines of 32 bytes; 8 clocks for a miss, 8 for a
# changed line that is replaced, 3 for a store to a line that is not in the cache, and 16 more if the page was not used lately.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
costs=$tests/../../machines/cpu/i860xr-cache.cfg
cp "$tests"/../../machines/cpu/{i860-calls.cfg,i860-hits.inc} .
sed '/^cache = {/,/^};/d; /^tlb = {/,/^};/d' "$costs" >without.cfg
"$BUILD/nxcc" -O2 --costs ./without.cfg -o cache "$tests/cache.c"
"$BUILD/nxcc" -O2 --costs i860xr-cache.cfg -o cached "$tests/cache.c"

# Prints the clocks that the cache adds to PASS over N elements.
adds() {
    run -m ipsc860 -q cache "$2"
    local without
    without=$(sed -n "s/^$1 //p" out)
    run -m ipsc860 -q cached "$2"
    echo $(($(sed -n "s/^$1 //p" out) - without))
}
near() { [ $(($1 - $2)) -le 40 ] && [ $(($2 - $1)) -le 40 ]; }

check "a small field misses once a line" near "$(adds first 512)" $((8 * 128 + 16))
check "a small field is there the second time" near "$(adds again 512)" 0
check "a large field misses once a line" near "$(adds first 8192)" $((8 * 2048 + 16 * 16))
check "a large field misses again" near "$(adds again 8192)" $((8 * 2048))
check "stores to what is there cost nothing" near "$(adds write 512)" 0
check "stores to what is not there cost 3 each and bring nothing in" near "$(adds write 65536)" $((3 * (65536 - 1024) + 16 * (128 - 2)))

check "lines of a small field that are changed stay" near "$(adds change 512)" 0
check "nothing is written back by reading them" near "$(adds last 512)" 0
check "lines of a large field come in, and changed ones go out" near "$(adds change 8192)" $(((8 + 8) * 2048))
check "and the last that were changed go out when it is read" near "$(adds last 8192)" $((8 * 2048 + 8 * 256))

# 16 KB, 4-way
"$BUILD/nxcc" -O2 --costs i860xp-cache.cfg -o cached "$tests/cache.c"
check "16 KB: lines of a large field come in, and changed ones go out" near "$(adds change 8192)" $(((8 + 8) * 2048))
check "16 KB: the last that were changed go out when it is read" near "$(adds last 8192)" $((8 * 2048 + 8 * 512))
check "16 KB: a field of 12 KB is there the second time" near "$(adds again 1536)" 0
"$BUILD/nxcc" -O2 --costs i860xr-cache.cfg -o cached "$tests/cache.c"

# The same however computing is cut, and nearly so with a profile, which pays otherwise and lays out the program's pages anew.
"$BUILD/nxcc" -O2 --profile --costs i860xr-cache.cfg -o profiled "$tests/cache.c"
run -m ipsc860 -q cached 8192
mv out whole
run -m ipsc860 -q --slice 0.000007 cached 8192
check "misses are paid at the same times in slices" cmp out whole
run -m ipsc860 -q profiled 8192
check "and with a profile" near "$(sed -n 's/^write //p' out)" "$(sed -n 's/^write //p' whole)"

sed 's/ways = 2/ways = 3/' "$costs" >three.cfg
"$BUILD/nxcc" --costs ./three.cfg -c "$tests/cache.c" >out 2>err
status=$?
check "a cache of three ways is refused" said "three.cfg:[0-9]+: cache: 'ways' must be a power of two"
sed 's/entries = 64/entries = 4096/' "$costs" >wide.cfg
"$BUILD/nxcc" --costs ./wide.cfg -c "$tests/cache.c" >out 2>err
status=$?
check "a translation buffer of 4096 entries is refused" said "wide.cfg:[0-9]+: tlb: must have 1 to 4 ways and 1 to 64 sets"

# --- the costs that a program was compiled with, and the machine's ---
told() { said "^touchstone run: cost was compiled with the costs of $1, but $2 has those of $3: nxcc --costs .*/$3\$"; }
silent() { ! grep -q 'was compiled with' err; }
echo 'int part(void) { return 0; }' >part.c
echo 'int part(); int main(void) { return part(); }' >cost.c
"$BUILD/nxcc" -o cost cost.c part.c
run -m ipsc860 -n 1 cost
check "the machine has the usual costs: nothing is said" silent
run -m paragon -n 1 cost
check "a Paragon counts the same clocks, and its own are shorter" silent
"$BUILD/nxcc" --costs i860xr-cache.cfg -c cost.c
"$BUILD/nxcc" -o cost cost.o part.c
run -m ipsc860 -n 1 cost
check "one file of two was compiled with other costs" told i860xr-cache.cfg ipsc860 i860.cfg
"$BUILD/nxcc" --costs i860xr-cache.cfg -o cost cost.c part.c
run -m ipsc860 -n 1 cost
check "the machine has other costs" told i860xr-cache.cfg ipsc860 i860.cfg
run -q -m ipsc860 -n 1 cost
check "-q tells no times: nothing is said" silent
run -m ipsc860 --set node.cpu=cpu/i860xr-cache.cfg -n 1 cost
check "compiled for the machine: nothing is said" silent
