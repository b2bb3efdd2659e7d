#!/bin/bash
# profile.sh - touchstone run --profile: a program's time by function; the run is that without --profile.
. "$(dirname "$0")/common.bash"

digest() { sed -n 's/^digest *//p' "$1"; }

# profiled NODES SOURCE - builds SOURCE both ways and runs it both ways: out, err and p.json of the second
profiled() {
    "$BUILD/nxcc" -O2 -o plain "$2" -lm && "$BUILD/nxcc" -O2 --profile -o profiled "$2" -lm || return 1
    run -m ipsc860 -n "$1" plain
    mv out out.plain
    mv err err.plain
    run -m ipsc860 -n "$1" --json j.json --profile p.json profiled
}
same() { cmp out out.plain && [ "$(digest err)" = "$(digest err.plain)" ]; }

# The functions' units, the classes', and by --json what the nodes computed.
adds_up() {
    awk '/"functions"/ { f = 1 } !f && /"units":/ { classes += $2 } f && /^   "units":/ { functions += $2 }
         /"units_per_second"/ { hz = $2 + 0 } /"busy_s"/ { busy += $2 }
         END { printf "%d %d %.3f\n", classes, functions, busy * hz
               exit !(classes > 0 && classes == functions && classes == int(busy * hz + 0.5)) }' p.json j.json
}
# A class's computing, system, idle and other time are its nodes' time.
whole() {
    awk '/"(computing|system|idle|rest)_s":/ && /^   / { sum += $2 } /"node_time_s"/ { all += $2 }
         /"waits": \[/ { exit } END { print sum, all; exit !(all > 0 && (sum - all) ^ 2 < 1e-18) }' p.json
}

for source in e2e/ring nx/handler_computing nx/handlers_nest_not nx/global nx/order nx/complete_exchange; do
    check "$source: builds" profiled 4 "$tests/../$source.c"
    check "$source: prints and sends the same at the same times" same
    check "$source: its functions add up to what it computed" adds_up
    check "$source: nothing is left over" test "$(grep -c 'compiled without' p.json)" = 0
done
check "the global operations are nxcc's own code, and are told as well" profiled 8 "$tests/../nx/global.c"
check "by file" grep -q 'nx_api/common/global.c' p.json
profiled 2 "$tests/../nx/handler_computing.c"
check "all time of a class adds up" whole
check "there are two classes" grep -q '"with_handlers"' p.json
check "the summary shows the dearest, and where they are written" said '^ *[0-9.]+% +[0-9.]+% +[0-9.]+% +[0-9.]+  main .*handler_computing.c:[0-9]+$'
check "and the library's functions by who calls them" said 'printf called by main'
check "no other file is left" test "$(echo p.json*)" = p.json
run -q -m ipsc860 -n 2 --profile p.json profiled
check "-q shows nothing" test ! -s err

run -n 2 --profile p2.json plain
check "a program built otherwise is an error" ended_with 65
check "that says how to build it" said 'nxcc --profile'
check "and writes nothing" test ! -e p2.json
echo 'int main(void) { volatile int x = 0; while (x < 1000) x += 1; return 0; }' >short.c
"$BUILD/nxcc" -O2 --profile -o short short.c && run -n 1 --profile short.json short
check "a short run's seconds have five digits" grep -qE '^100.00% +0\.000[0-9]{5} +main ' err
run -n 2 --profile nowhere/p.json profiled
check "so is a file that cannot be written" said 'nowhere/p.json cannot be written'

echo 'long work(long n); int main(void) { return work(100000) == 1; }' >a.c
echo 'long work(long n) { long s = 0; while (n-- > 0) s += n % 3; return s; }' >b.c
parts() { "$BUILD/nxcc" -O2 -c b.c && "$BUILD/nxcc" -O2 --profile -o ab a.c b.o; }
check "parts may be compiled without it" parts
run --profile p.json --json j.json ab
check "and are told as a whole" said '\(compiled without --profile\)'
check "so that all adds up" adds_up

printf '#include <unistd.h>\nint main(void) { sleep(1000000); return 0; }\n' >long.c
"$BUILD/nxcc" -O2 --profile -o long long.c
run -n 32 --profile long.json long
check "32 nodes for a million seconds: more picoseconds than 64 bits hold" grep -qE '^100\.00% +32000000  \(idle\)' err
check "and so in the file" grep -q '"idle_s": 32000000.0,' long.json
