#!/bin/bash
# Compiles every program of tests/nx (with options that its head names: "compile: OPTIONS"), runs it on the machines its head
# names ("run: ARGS"), and compares what it prints, and its exit
# status if not 0 ("status N" as the last line), with NAME.out; where there is no such file, all runs must print the
# same, clock times included, and end well.
BUILD=${BUILD:-build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for source in tests/nx/*.c tests/nx/*.f tests/nx/*.f90; do
    name=$(basename "${source%.*}")
    options=$(sed -n 's/^[ cC!][ *]* compile: //p' "$source")
    # shellcheck disable=SC2086
    if ! $BUILD/nxcc -O2 -g -J "$work" $options -o "$work/$name" "$source" -lm 2>"$work/err"; then
        echo "not ok $name: does not compile"
        cat "$work/err"
        continue
    fi
    expected=tests/nx/$name.out
    [ -f "$expected" ] || expected=$work/first
    rm -f "$work/first"
    sed -n 's/^[ cC!][ *]* run: //p' "$source" >"$work/runs"
    while read -r arguments; do
        # shellcheck disable=SC2086
        $BUILD/touchstone run --max-wall-time 60 $arguments "$work/$name" >"$work/out" 2>"$work/err" </dev/null
        status=$?
        [ $status = 0 ] || echo "status $status" >>"$work/out"
        [ -f "$expected" ] || [ $status != 0 ] || cp "$work/out" "$work/first"
        if cmp -s "$work/out" "$expected"; then
            echo "ok $name $arguments"
        else
            echo "not ok $name $arguments"
            diff "$expected" "$work/out"
            cat "$work/err"
        fi
    done <"$work/runs"
done
