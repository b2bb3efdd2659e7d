#!/bin/bash
# examples.sh - the examples of programs that hang or go wrong (share/examples) compile as their heads say, and show their faults.
. "$(dirname "$0")/common.bash"
PATH=$BUILD:$PATH

# The first command of an example's head, which compiles it.
compile_example() { # NAME
    cp "$tests/../../share/examples/$1.c" .
    sed -n 's/^ \*    \(nxcc .*\)/\1/p' "$1.c" | bash -e
}
for name in deadlock lost_interrupt race message_race; do
    check "$name compiles as its head says" compile_example $name
    check "$name: without a warning" eval "nxcc -g -O2 -Wall -Wextra -o w $name.c 2>&1 | tee warnings; test ! -s warnings"
done

# --- deadlock: every node waits for its left neighbour ---
for machine in ipsc860 delta paragon; do
    run -q -m $machine -n 4 deadlock
    check "deadlock, $machine: is one" ended_with 2
    line=$(grep -n 'crecvx(BORDER' deadlock.c | cut -d: -f1)
    check "deadlock, $machine: of all nodes, in the line" test "$(grep -c "crecvx(7).*(deadlock.c:$line)" err)" -ge 1
done

check "deadlock: the report tells what kind it is" said 'cycle: node 0 -> node 3 -> node 2 -> node 1 -> node 0'
run -q -n 4 --deadlock why.json deadlock
check "deadlock: touchstone deadlock draws it" eval "touchstone deadlock why.json -o why.svg && xmllint --noout why.svg"

# --- lost_interrupt: goes well on four nodes, not on two ---
for machine in ipsc860 delta paragon; do
    run -q -m $machine -n 4 lost_interrupt
    check "lost_interrupt, $machine: goes well on four nodes" grep -qx '15 requests served' out
    run -q -m $machine -n 2 lost_interrupt
    check "lost_interrupt, $machine: not on two" ended_with 2
    line=$(grep -n 'crecv(WAKE' lost_interrupt.c | cut -d: -f1)
    check "lost_interrupt, $machine: node 0 waits for its handler" said "node 0: crecv\\(3\\).*lost_interrupt.c:$line"
done
check "lost_interrupt: the report says that the handler is masked" said 'handler masked: .*'
check "lost_interrupt: and whose it is" said "1 handler is due and does not run, that of hrecv\\(1\\) at lost_interrupt.c:[0-9]+"

# --- race: right on two nodes, not on four ---
for machine in ipsc860 delta paragon; do
    run -q -m $machine -n 2 race
    check "race, $machine: right on two nodes" grep -qx 'sum 210, which should be 210' out
    run -q -m $machine -n 4 race
    check "race, $machine: ends on four" ended_with 0
    check "race, $machine: with another sum" eval "grep -q 'which should be 630' out && ! grep -q 'sum 630' out"
done
nxcc --races -g -O2 -o checked race.c
run -q -m delta -n 2 checked
check "race, nxcc --races: found where the sum is right" eval "ended_with 3 && grep -qx 'sum 210, which should be 210' out"
put=$(grep -n 'stack\[height++\] = came' race.c | cut -d: -f1) back=$(grep -n 'height = top' race.c | cut -d: -f1)
check "race, nxcc --races: the variable and both lines" \
    said "race on height: handler writes at race.c:$put, main program writes at race.c:$back"

# --- message_race: right in the usual timing; wrong when node 1 is late ---
for machine in ipsc860 delta paragon; do
    run -q -m $machine -n 3 message_race
    check "message_race, $machine: right in the usual timing" grep -qx 'sum of 400 terms: 98.204945' out
done
if "$BUILD/touchstone" run --help | grep -q -- --replay; then
    printf '%s\n' 'touchstone-schedule 1' 'nodes 3' 'message 1 0 5000000000' >late
    run -q -n 3 --replay late message_race
    check "message_race: wrong when node 1 is late" eval "grep -q 'sum of 400 terms: ' out && ! grep -q 98.204945 out"
fi
# (Here: touchstone explore.)
