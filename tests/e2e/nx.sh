#!/bin/bash
# nx.sh - conformance. Compiles every program of tests/nx, runs it on simulated machines, and compares its output, and its exit
# status if not 0 ("status N" as the last line), with NAME.out. Without such a file, the output of all runs must be equal,
# clock times included, and the exit status 0. A program's head says
#     run: ARGS          the machine; "all" is 1, 2, 3, 8 and 33 nodes of a hypercube and of a mesh
#     compile: OPTIONS   for nxcc
#     again: OPTIONS     compiled once more, with these options, too: all runs print the same
#     stdin: TEXT        a line for its standard input
# without: touchstone-lab app
BUILD=$(cd "${BUILD:-build}" && pwd)
. tests/patience.bash
. tests/compiled.bash
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# (What sanitizers find does not depend on so many numbers of nodes.)
all=$(printf -- '-m %s\n' {ipsc860,delta}' -n '{1,2,3,8,33})
[[ $BUILD != *asan* ]] || all=$(printf -- '-m %s\n' 'ipsc860 -n 2' 'delta -n 33')

machines() { # of a program, one a line
    sed -n 's/^[ cC!][ *]* run: //p' "$1" | while read -r run; do
        if [ "$run" = all ]; then
            echo "$all"
        else
            echo "$run"
        fi
    done
}

# Every program is named in the table of rules, and every name there is a program's.
sed -n 's/^| [^|]* | \([^|]*\) |$/\1/p' tests/nx/RULES.md | tail -n +2 | tr ' ' '\n' | sort -u >"$work/named"
for source in tests/nx/*.c tests/nx/*.f tests/nx/*.f90; do basename "${source%.*}"; done | sort -u >"$work/there"
if diff "$work/named" "$work/there"; then echo "ok RULES.md names the programs"; else echo "not ok RULES.md names the programs"; fi

compiled() { # NAME SOURCE OPTIONS...
    local modules=() libraries=() # (as compile_rule in common.bash: other tests have the same programs)
    [ "${2%.c}" != "$2" ] && libraries=(-lm) || modules=(-J "$work")
    if ! compiled_once "$work/$1" nxcc -O2 -g "${modules[@]}" "${@:3}" "$(whole "$2")" "${libraries[@]}" 2>"$work/err"; then
        echo "not ok $1 ${*:3}: does not compile"
        cat "$work/err"
        false
    fi
}

run_all() { # NAME OPTIONS...: on its machines
    while read -r arguments; do
        # shellcheck disable=SC2086
        (cd "$work" && "$BUILD/touchstone" run --max-wall-time $patience $arguments "$1" >out 2>err <in)
        status=$?
        [ $status = 0 ] || echo "status $status" >>"$work/out"
        [ -f "$expected" ] || [ $status != 0 ] || cp "$work/out" "$work/first"
        if cmp -s "$work/out" "$expected"; then
            echo "ok $* $arguments"
        else
            echo "not ok $* $arguments"
            diff "$expected" "$work/out"
            cat "$work/err"
        fi
    done <"$work/runs"
}

for source in tests/nx/*.c tests/nx/*.f tests/nx/*.f90; do
    name=$(basename "${source%.*}")
    options=$(sed -n 's/^[ cC!][ *]* compile: //p' "$source")
    expected=$PWD/tests/nx/$name.out
    [ -f "$expected" ] || expected=$work/first
    rm -f "$work/first"
    sed -n 's/^ \* stdin: //p' "$source" >"$work/in"
    machines "$source" >"$work/runs"
    # shellcheck disable=SC2086
    compiled "$name" "$source" $options && run_all "$name"
    while read -r again; do
        # shellcheck disable=SC2086
        compiled "$name" "$source" $options $again && run_all "$name" $again
    done < <(sed -n 's/^[ cC!][ *]* again: //p' "$source")
done
