#!/bin/bash
# mpi_nx.sh - the conformance programs of tests/nx on MPI, on as many nodes as they run on elsewhere, if no more than 8: the
# same output, lines in any order (that of different nodes' output is mpirun's), and the same exit status.
#
# Not here, and why:
not_here="
    busy_system         times a system that is behind with messages: virtual time
    cfs_handlers        compares virtual times
    cfs_killed          how far a write has got at a virtual time
    cfs_overlap         iread and iwrite take the time of the whole transfer here
    duplex              compares virtual times
    handler_computing   compares virtual times; mpi.sh has handlers that interrupt
    long32              nxcc --long32 is for simulated nodes
    memory              a node has the memory of its host
"
BUILD=${BUILD:-build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
. tests/e2e/mpi.bash

for source in tests/nx/*.c; do
    name=$(basename "$source" .c)
    grep -q "^    $name  " <<<"$not_here" && continue
    if ! $BUILD/nxcc --mpi -O2 -g -o "$work/$name" "$source" -lm 2>"$work/err"; then
        echo "not ok $name: does not compile"
        cat "$work/err"
        continue
    fi
    for nodes in $(sed -n 's/^ \* run: .*-n \([0-9]*\).*/\1/p' "$source" | sort -un); do
        [ "$nodes" -le 8 ] || continue
        on_mpi "$nodes" "$work/$name" </dev/null
        [ $status = 0 ] || echo "status $status" >>"$work/out"
        if diff <(sort "tests/nx/$name.out") <(sort "$work/out") >"$work/differ"; then
            echo "ok $name on $nodes"
        else
            echo "not ok $name on $nodes"
            cat "$work/differ" "$work/err"
        fi
    done
done
