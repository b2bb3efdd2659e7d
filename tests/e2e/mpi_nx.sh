#!/bin/bash
# mpi_nx.sh - the conformance programs of tests/nx on MPI, on as many nodes as they run on elsewhere, if no more than 8: the
# same output, lines in any order (that of different nodes' output is mpirun's), and the same exit status.
# without: touchstone-lab app
#
# Not here, and why:
not_here="
    busy_system         times a system that is behind with messages: virtual time
    cfs_handlers        compares virtual times
    cfs_killed          how far a write has got at a virtual time
    cfs_overlap         compares times (mpi_files.sh has transfers that overlap)
    duplex              compares virtual times
    handler_computing   compares virtual times; mpi.sh has handlers that interrupt
    memory              a node has the memory of its host
"
BUILD=${BUILD:-build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
. tests/e2e/mpi.bash

for source in tests/nx/*.c tests/nx/*.f tests/nx/*.f90; do
    name=$(basename "${source%.*}")
    grep -q "^    $name  " <<<"$not_here" && continue
    grep -q '^[ cC!][ *]* simulator only: ' "$source" && continue
    options=$(sed -n 's/^[ cC!][ *]* compile: //p' "$source")
    # shellcheck disable=SC2086
    if ! $BUILD/nxcc --mpi -O2 -g -J "$work" $options -o "$work/$name" "$source" -lm 2>"$work/err"; then
        echo "not ok $name: does not compile"
        cat "$work/err"
        continue
    fi
    sed -n 's/^ \* stdin: //p' "$source" >"$work/in"
    for nodes in $(sed -n 's/^[ cC!][ *]* run: //; T; s/^all$/-n 3\n-n 8/; p' "$source" | sed 's/.*-n \([0-9]*\).*/\1/' | sort -un); do
        [ "$nodes" -le 8 ] || continue
        on_mpi "$nodes" "$work/$name" <"$work/in"
        [ $status = 0 ] || echo "status $status" >>"$work/out"
        if diff <(sort "tests/nx/$name.out") <(sort "$work/out") >"$work/differ"; then
            echo "ok $name on $nodes"
        else
            echo "not ok $name on $nodes"
            cat "$work/differ" "$work/err"
        fi
    done
done
