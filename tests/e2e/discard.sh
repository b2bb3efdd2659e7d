#!/bin/bash
# discard.sh - the deadlock of two groups that hand their nodes to each other, which the paper's authors met. The model (app/)
# avoids it by its discard rule: a finished host answers the request of a new node with DISCARD (app/group.c). Here the rule
# is taken out (discard.patch), in a copy of app/.
#
# The smallest run that can deadlock, and does not in the machine's usual timing, is of two nodes, each a group of its own:
#
#     touchstone run -m ipsc860 -n 2 model $two_groups
#
# Each host tells the other HALF_LEFT, its first CONTROL message, some 0.6 ms before it finishes, and then GROUP_DONE; the two finish
# within 0.1 ms of each other. When the handler of HALF_LEFT, the first handler of a node, begins 1 ms late on both (on_control in
# service.c: handlers wait while they are masked, while another runs, while the processor moves bytes), each host deals itself to the
# other, asks it for work, and is never answered: both wait in msgwait (slave.c). That is the cycle. With the rule the same delays
# change nothing. Of the timings that `touchstone run --timing SEED,interrupts=1ms` draws, about one in four deadlocks; of those of
# interrupts=2ms one in two, and some of them in the cycle. (With the usual bounds, interrupts=50us, none of 40 did.)
# `touchstone explore` shall find that, and the two delays.
# without: touchstone-lab
. "$(dirname "$0")/common.bash"
two_groups="-group 1 -sphere 20 20 3 -shares layers -preload -nooverlap -half 0.01 -digest"

cp -r "$tests/../../app" app && mkdir ruled && cp app/* ruled
check "the rule can be taken out" patch -s -p1 -i "$tests/discard.patch"
build_model() { # FOLDER PROGRAM
    "$BUILD/nxcc" -g -O2 -o "$2" "$1"/*.c -lm
}
check "the model without the rule compiles" build_model app without
check "and with it" build_model ruled with

# shellcheck disable=SC2086
model() { # PROGRAM OPTIONS...: with options of touchstone run
    local program=$1
    shift
    run -q -m ipsc860 -n 2 "$@" "$program" $two_groups
    grep -E '^polygon(s|s_by_isovalue|_digest) ' out >polygons
}
waits_for_chunk() { # NODE
    grep -Eq "nodes? ([01], )*$1(, [01])*: .*msgwait.*slave\.c:" err
}
model with
cp polygons right
check "with the rule: there are polygons" grep -qE '^polygons [1-9]' right
model without
check "without it, in the usual timing: the run ends" ended_with 0
check "with the same polygons" cmp right polygons

# More nodes deadlock without the rule in the usual timing, too: some node asks a finished host. With it they do not.
for nodes in 4 6 8; do
    for program in without with; do
        run -q -m ipsc860 -n $nodes $program -group 2 -sphere 24 16 9 -shares layers -half 0.01
        echo "$nodes $program $status"
    done
done >ends
check "without the rule some of three larger runs deadlock" grep -q 'without 2' ends
check "with it none does" test "$(grep -c 'with 0' ends)" = 3

# The parts that need delays.
"$BUILD/touchstone" run --help | grep -q -- --replay || exit 0
printf '%s\n' 'touchstone-schedule 1' 'nodes 2' 'interrupt 0 0 1000000000' 'interrupt 1 0 1000000000' >late
model without --replay late
check "the handlers of HALF_LEFT late: a deadlock" ended_with 2
check "of node 0, which waits for a chunk of node 1" waits_for_chunk 0
check "and of node 1, which waits for one of node 0" waits_for_chunk 1
check "each waits for the other: a cycle" said 'cycle: node 0 -> node 1 -> node 0'
model with --replay late
check "with the rule: the run ends" ended_with 0
check "with the same polygons" cmp right polygons
for program in without with; do
    for ((seed = 1; seed <= 20; seed++)); do
        model $program --timing $seed,interrupts=2ms
        echo "$program $status"
        [ $status != 0 ] || check "seed $seed, $program: the same polygons" cmp right polygons
    done
done >drawn
grep -v '^with' drawn
check "some of 20 drawn timings deadlock without the rule" grep -qx 'without 2' drawn
check "and others do not" grep -qx 'without 0' drawn
check "with the rule none does" test "$(grep -cx 'with 0' drawn)" = 20
