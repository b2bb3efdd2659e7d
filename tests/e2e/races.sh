#!/bin/bash
# races.sh - the pairs of tests/races: each seeded fault is reported with its variable and its lines, and none of the correct
# programs that look alike. Both print the same: the fault does not show in this run's timing, and is found all the same.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
seeds=$tests/../races
pairs=0

compiled() { # SOURCE OPTIONS...
    local compiler=nxcc
    [ "${1##*.}" = F ] && compiler=nxf77
    compiled_once seed $compiler --races -O2 -g "$@"
}

run_seed() { # SOURCE OPTIONS...
    check "$(basename "$1") ${*:2}: compiles" compiled "$@"
    run -m delta -n "$(sed -n 's/.*run: -n \([0-9]*\).*/\1/p' "$1" | grep . || echo 2)" seed
}

# Is there a report on the fault's variable (one of the names of it that the head gives) that names both lines that the source marks;
# if it marks one, that line for both accesses? (Of one variable the head names the first pair of lines, lines below the others.)
reported() { # SOURCE
    local variable first last file
    file=$(basename "$1" | sed 's/\./\\./')
    variable=$(sed -nE 's/^( \*|c    ) variable: ([a-z0-9_|]+).*/\2/p' "$1")
    first=$(grep -nE '/\* RACE \*/|! RACE' "$1" | head -1 | cut -d: -f1)
    last=$(grep -nE '/\* RACE \*/|! RACE' "$1" | tail -1 | cut -d: -f1)
    awk '/^race on/ { head = $0; sub(/:.*/, "", head); also = 0 } /^  also/ { also = 1 }
         also { sub(/^ +(also +)?/, ""); $0 = head ": " $0 } { print }' err |
        grep -E "^race on [^:]*\<($variable)\>[^:]*: .*$file:($first\>.*$file:$last|$last\>.*$file:$first)\>"
}

for pair in $(grep -l CORRECT "$seeds"/*.[cF]); do
    name=$(basename "$pair")
    run_seed "$pair"
    mv out fault.out
    check "$name: the fault is reported" reported "$pair"
    check "$name: status 3" ended_with 3
    run_seed "$pair" -DCORRECT
    check "$name -DCORRECT: is checked, and nothing is reported" eval "grep -qx 'races  *0 found' err && ! said '^race on'"
    check "$name -DCORRECT: status 0" ended_with 0
    check "$name: prints the same with -DCORRECT" eval "[ -s out ] && diff fault.out out"
    pairs=$((pairs + 1))
done
for level in -O0 -O2; do
    run_seed "$seeds/f77_counter.F" $level
    check "f77_counter.F $level: a handler's load from a COMMON block has its own line, not that of the END above" \
        said '^race on ndone: handler reads and writes at f77_counter\.F:35, main program [a-z ]*writes at f77_counter\.F:19$'
done
check "at least thirty pairs" test "$pairs" -ge 30
