#!/bin/bash
# workers.sh - any number of workers, scheduled in any order, gives equal results: what programs print, all figures (but wall
# times), messages about failures, exit status, profiles. Every program of tests/nx, and the failing programs of the other
# tests, with one worker and then with several in random order.
# without: touchstone-lab
. "$(dirname "$0")/common.bash"
nx=$(cd "$tests/../nx" && pwd)
# A stopped program does not free its memory; LeakSanitizer's reports differ by their addresses.
export ASAN_OPTIONS=detect_leaks=0

# In the order of long slices, and in random order with short ones: slice boundaries must not matter. (Random order with long slices
# is ThreadSanitizer's way.)
WAYS=("-w 2" "-w 4 --shuffle 2 --slice 0.0001")
[[ $BUILD != *asan* ]] || WAYS=("-w 4 --shuffle 2 --slice 0.0001")

same() { # NAME ARGS...
    local name=$1
    shift
    run_unsanitized -w 1 "$@" >one # (nx.sh has these programs with sanitizers, too)
    for way in "${WAYS[@]}"; do
        # shellcheck disable=SC2086
        run_results $way "$@" >several
        check "$name: $way" diff one several
    done
    under_tsan "$name" "$@"
}

# ThreadSanitizer's reports of data races would be among the errors. It cannot run programs that leave their stack by a
# fault, and has nodes at addresses with fewer digits, which calls_under_way writes as text.
under_tsan() { # NAME ARGS...
    local name=$1 touchstone=$BUILD/tsan/touchstone
    shift
    case $name in *crash* | calls_under_way*) return ;; esac
    if [ -x "$touchstone" ]; then
        run_results -w 3 --shuffle 4 "$@" >several
        check "$name: no data races, and the same" diff one several
    fi
}
[ -x "$BUILD/tsan/touchstone" ] || echo "skip no build with ThreadSanitizer"

for source in "$nx"/*.c; do
    name=$(basename "$source" .c)
    compile_rule "$source"
    arguments=$(first_run "$source")
    # shellcheck disable=SC2086
    same "$name $arguments" $arguments "$name"
done

for name in ring crash deadlock flood greedy quits halves cut deferred_calls; do
    compile $name
done
same "ring" -m ipsc860 -n 16 ring
same "a crash" -n 4 crash
same "a deadlock" -n 3 deadlock
same "too little memory" -n 2 flood
same "malloc without end" -n 2 greedy
same "exit(3)" -n 4 quits
same "killed while computing" -n 8 cut kill
same "all killed while computing" -n 8 cut cube
same "a crash among others that compute" -n 8 cut crash
same "one fails while others compute" -n 8 cut fail
for turns in 0 260 777 1500 3100; do
    for how in kill fail crash cube; do
        same "$how after $turns turns, while others send and receive" -n 6 deferred_calls $turns $how
    done
done
same "a time limit while all send and receive" --max-virtual-time 0.002 -n 6 deferred_calls 9000 kill
same "a time limit" --max-virtual-time 0.3 -n 8 cut kill

"$BUILD/nxcc" -O2 --profile -o cut_profile "$tests/cut.c" -lm
profile() { # WORKERS...
    run_results "$@" -n 8 --profile p.json cut_profile kill
    cat p.json 2>/dev/null
}
profile -w 1 >one
profile -w 3 --shuffle 5 >several
check "profile of programs cut short" diff one several

compiled_once model_profile nxcc -O2 --profile "$tests"/../../app/*.c -lz -lm
model() { # WORKERS...
    run_results "$@" -n 16 --profile p.json model_profile -approx 111 -sphere 64 64 9 -group 4
    cat p.json 2>/dev/null
}
model -w 1 >one
check "the model program ends well" grep -q '^status 0' one
touchstone=$BUILD/tsan/touchstone
if [ -x "$touchstone" ]; then
    model -w 4 --shuffle 9 >several
    check "the model program: no data races, and the same" diff one several
fi
unset touchstone
for way in "-w 2" "-w 4 --shuffle 7"; do
    # shellcheck disable=SC2086
    model $way >several
    check "the model program: $way" diff one several
done
