#!/bin/bash
# memory_sizes.sh - nodes of 16 and 8 MB: programs that fit only the larger, and the high-water mark to the byte.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
compile sizes
"$BUILD/nxcc" -O2 -DFIELD=9000000 -o field "$tests/sizes.c"
mb10=10485760

run -m ipsc860 -n 2 sizes $mb10
check "10 MB from malloc: fit a node of 16 MB" ended_with 0
run -m ipsc860-8mb -n 2 sizes $mb10
check "10 MB from malloc: not a node of 8 MB" ended_with 1
check "10 MB from malloc: the report says what was short" said "memory was exhausted.*$mb10|$mb10.*memory was exhausted"

run -m ipsc860 field
check "a program of 9 MB: fits a node of 16 MB" ended_with 0
run -m ipsc860-8mb field
check "a program of 9 MB: not a node of 8 MB" ended_with 65
check "a program of 9 MB: sizes and machine are named" \
    said 'does not fit: program 9[0-9]{6} bytes and stack 524288 bytes, but a node of ipsc860-8mb leaves 6815744'

# A block takes its bytes rounded up to 16, and 16 more.
peak() {
    run -m ipsc860 --json figures sizes "$@"
    sed -n 's/.*"memory_peak_bytes": \([0-9]*\).*/\1/p' figures | sort -u
}
took() {
    echo $(($(peak "$@") - none))
}
none=$(peak)
check "high-water mark: one byte" test "$(took 1)" = 32
check "high-water mark: 1,000,000 bytes" test "$(took 1000000)" = 1000016
check "high-water mark: 1,000,001 bytes" test "$(took 1000001)" = 1000032
check "high-water mark: several blocks add up" test "$(took 1000 20000 300000)" = $((1008 + 16 + 20016 + 300016))
check "high-water mark: freed blocks do not add up" test "$(took -50000 -60000 40000)" = 60016
