#!/bin/bash
# flame.sh - touchstone profile: paths of calls, flame graphs, lines of source and differences, which add up.
. "$(dirname "$0")/common.bash"

profile() {
    "$BUILD/touchstone" profile "$@" >out 2>err </dev/null
    status=$?
}

# What a figure of the nodes comes to by --json, in picoseconds.
of_nodes() { awk -v name="   \"$1\":" 'index($0, name) == 1 { sum += int($2 * 1e12 + 0.5) } END { printf "%.0f\n", sum }' j.json; } # by its indentation: a wait has "idle_s", too
# The folded stacks whose last frame is one of the system, of waiting, or neither. Reads nothing else of them.
folded_sum() { # WHAT
    awk -v what="$1" '{ n = split($0, part, " "); time = part[n]; stack = $0; sub(/ [0-9]+$/, "", stack)
         depth = split(stack, frame, ";"); last = frame[depth]
         kind = last == "(waiting)" ? "idle" : last ~ /^(csend|crecv|hrecv|exit|\(interrupts?\)|\(the end of a handler\)|\(system\))$/ ? "system" : "busy"
         if (kind == what) sum += time } END { printf "%.0f\n", sum }' folded
}
sums_agree() {
    local kind
    for kind in busy system idle; do
        echo "$kind: $(of_nodes ${kind}_s) by nodes, $(folded_sum $kind) by frames"
        [ "$(of_nodes ${kind}_s)" = "$(folded_sum $kind)" ] && [ "$(folded_sum $kind)" -gt 0 ] || return 1
    done
}
has() { grep -qE "^$1 [0-9]+$" folded; }
time_of() { awk -v stack="$1" '{ time = $NF; sub(/ [0-9]+$/, ""); if ($0 == stack) print time }' folded; }

check "it builds" "$BUILD/nxcc" -O2 --profile -o flame "$tests/flame.c"
check "and without a profile" "$BUILD/nxcc" -O2 -o plain "$tests/flame.c"
run -n 4 plain
sed -n '/^digest\|^virtual/p' err | sed 's/ on .*//' >digest.plain
mv out out.plain
run -n 4 --isolate --profile p.json --json j.json flame
check "the profile changes no time and no message" cmp digest.plain <(sed -n '/^digest\|^virtual/p' err | sed 's/ on .*//')
check "and no output" cmp out.plain out

profile -f folded p.json
cp out folded
check "frames add up to what the nodes computed, had the system work, and waited" sums_agree
check "recursion is a path" has 'main;deep;deep;deep;deep;deep;deep;work'
check "and no deeper than it was" test "$(grep -c 'deep;deep;deep;deep;deep;deep;deep' folded)" = 0
check "its levels cost the same" test "$(time_of 'main;deep;deep')" = "$(time_of 'main;deep;deep;deep')"
check "a handler is called by no function" has '\(handlers\);handler;work'
check "and interrupts" has '\(handlers\);\(interrupt\)'
check "who is called back is called by the caller of the library" has 'main;compare;work'
check "longjmp leaves the paths" has 'main;catch_jump;work'
check "as deep as they were" has 'main;catch_jump;jump;jump;jump;jump;work'
check "exit inside of a function" has 'main;leave;work'
check "a wait is within its call and its function" has 'main;crecv;\(waiting\)'
check "NX's own functions have frames, too" has 'main;gsync;.*\(waiting\)'

for workers in 1 3; do
    run -n 4 -q --workers $workers --profile w.json flame
    profile -f folded w.json
    check "the same with $workers workers" cmp out folded
done
"$BUILD/touchstone-reference" run -q -n 4 --profile w.json flame >out 2>err
profile -f folded w.json
check "the reference engine has the same frames" cmp out folded

# nodes
profile -f folded --nodes 0 p.json
awk '{ sum += $NF } END { printf "%.0f\n", sum }' out >node0
profile -f folded --nodes 1-3 p.json
awk '{ sum += $NF } END { printf "%.0f\n", sum }' out >nodes
check "nodes add up to all" test $(($(cat node0) + $(cat nodes))) = "$(awk '{ sum += $NF } END { printf "%.0f\n", sum }' folded)"
profile --nodes 9 p.json
check "a node that is not there is an error" said 'p.json: has none of these nodes: its nodes are 0 to 3'

# lines
line=$(grep -n 'sum += i % 7' "$tests/flame.c" | cut -d: -f1)
profile --lines p.json
check "the dearest line is told with its source" grep -qE "^ +[0-9.]+% +[0-9.]+ +.*flame.c:($line|$((line - 1))) +work +.*(sum \+= i % 7;|for \(long i)" out
profile --lines -f json p.json
lines=$(awk '/"time_ps"/ { sum += $2 } END { printf "%.0f\n", sum }' out)
check "lines add up to computing" test "$lines" = "$(of_nodes busy_s)"

# differences
sed 's/work(100);/work(3000);/; s/deep(5)/deep(4)/' "$tests/flame.c" >changed.c
"$BUILD/nxcc" -O2 --profile -o changed changed.c
run -q -n 4 --profile q.json changed
profile --diff p.json -f folded q.json
check "a folded difference has both times" test "$(awk '$1 == "main;deep;deep;deep;deep;deep;deep;work"' out)" = "main;deep;deep;deep;deep;deep;deep;work $(time_of 'main;deep;deep;deep;deep;deep;deep;work') 0"
profile --diff p.json q.json
check "a table tells what has grown most" grep -qE '^ +[0-9.]+ +[0-9.]+ +\+[0-9.]+  main;(work|crecv;\(waiting\))$' out
profile --diff p.json p.json
check "a run has not changed from itself" grep -q 'Nothing has changed' out
profile --diff p.json -o diff.svg q.json
check "a difference is drawn" grep -q 'red: itself takes more' diff.svg

# the picture
profile -o flame.svg p.json
check "the picture is XML" xmllint --noout flame.svg
check "its head has a time for people" grep -qE '>width: virtual time, summed over nodes: [0-9.]{4,6} m?s in all\.' flame.svg
check "refers to nothing outside" test "$(grep -cE '(href|src|url\()' flame.svg)" = 0
check "has a frame for each wide one" test "$(grep -c "data-n='deep'" flame.svg)" -ge 1
check "that tells its time" grep -qE '<title>main: [0-9.]+ %, [0-9.]+ m?s.*flame.c:[0-9]+</title>' flame.svg
check "no other file is left" test "$(echo flame.svg*)" = flame.svg

# mistakes
profile j.json
check "another file of JSON is no profile" said 'j.json: is no profile: touchstone run --profile FILE writes one'
profile nowhere.json
check "a file that is not there is said" said 'nowhere.json cannot be read: No such file'
echo 'TSTR' >t.trace
profile t.trace
check "any other file is no profile" said 't.trace: is no profile'
sed 's/"0 f /"99999 f /' p.json >damaged.json
profile damaged.json
check "a damaged one is said" said 'damaged.json: its spot [0-9]+ cannot be read'
check "with the status of wrong input" ended_with 65
profile --lines -f svg p.json
check "lines are no picture" said '--lines is with -f text or json'

profile --json one.json -o two.svg p.json
check "--json leaves no other output" said '--json FILE is the same as -f json -o FILE'

# Fortran
check "Fortran builds" "$BUILD/nxf77" -O2 --profile -o fortran "$tests/flame.f"
run -n 2 --profile f.json --json j.json fortran
profile -f folded f.json
cp out folded
check "Fortran's subroutines are frames" has 'main;flame;relax;exchange;crecv_;crecv;\(waiting\)'
profile --lines f.json
check "and have lines" grep -qE 'flame.f:[0-9]+ +relax_? +s = s \+ 1d0 / i' out

# 32 nodes for a million seconds: more picoseconds than 64 bits hold
printf '#include <unistd.h>\nint main(void) { sleep(1000000); return 0; }\n' >long.c
"$BUILD/nxcc" -O2 --profile -o long long.c
run -n 32 --profile long.json long
profile long.json
check "a table of more picoseconds than 64 bits hold" grep -qE '^100\.00% 100\.00% +32000000 +\(waiting\)$' out
profile -f folded long.json
check "and stacks" grep -q '^main;sleep;(waiting) 32000000000000000000$' out
