#!/bin/bash
# mpi_win.sh - MPI programs on simulated nodes access each other's memory: equal in both engines and with all workers.
. "$(dirname "$0")/common.bash"

"$BUILD/nxcc" --as-mpi bin >links
check "mpicc compiles" bin/mpicc -O2 -g -Wall -o mpi_win "$tests/mpi_win.c"

for on in "delta -n 4" "delta -n 9" "paragon -n 7" "ipsc860 -n 2" "delta -n 1"; do
    # shellcheck disable=SC2086
    run -q -m $on mpi_win
    check "$on: all holds" test "$status:$(grep -c ': yes$' out):$(grep -c NO out)" = 0:6:0
    # shellcheck disable=SC2086
    equal_results "$on" -m $on mpi_win
done
run -q -m delta -n 4 --set mpi_eager_limit=0 mpi_win
check "no send is eager: all holds" test "$status:$(grep -c ': yes$' out)" = 0:6
run -q -n 4 mpi_win outside
check "an access outside of the window: rank, call and what there is" said \
    "node [0-3], at [0-9.]+ [mun]?s: MPI_Get: rank 1's window has 8 bytes in units of 4"
check "and the program's line" said "main.*mpi_win\.c:$(grep -n 'MPI_Get(&rank' "$tests/mpi_win.c" | cut -d: -f1)"

# Reports of deadlocks name what MPI knows, not the library's messages.
check "mpicc compiles" bin/mpicc -O2 -g -Wall -o stuck "$tests/mpi_win_stuck.c"
while IFS='|' read -r how wait remedy; do
    run -q -n 2 stuck $how
    check "$how: a deadlock" ended_with 2
    check "$how: the call, without the library's tags" said "^  nodes? [01, ]+: MPI_Win_[a-z]+ since .*mpi_win_stuck\.c:"
    check "$how: what it waits for, and whom" said "cycle: .*It waits for $wait, which waits, too\."
    check "$how: what to do" said "^    $remedy"
    check "$how: no tag of the library's is named, and no communicator that the program does not know" eval '! said "tag [1-4]|communicator [0-9]"'
done <<'END'
fence|a message of collective 1 of window 2 from node 0|All ranks of a window have to call MPI_Win_fence
start|MPI_Win_post of window 2 \(halo\) from node 1|MPI_Win_start waits for MPI_Win_post
wait|an access, or MPI_Win_complete, of window 2 from node 1|MPI_Win_start waits for .* MPI_Win_wait for their MPI_Win_complete
lock|the lock of node 1's memory in window 2: node 0 has it|A rank that has a lock gives it back
cross|the lock of node 1's memory in window 2: node 1 has it|A rank that has a lock gives it back
starts|MPI_Win_post of window 2 from node 1|.*A rank that does both posts first
waits|an access, or MPI_Win_complete, of window 2 from node 1|.*A rank that does both posts first
END
run -q -n 2 stuck lock
check "a cycle goes by way of who has the lock" said "^  cycle: node 0 -> node 1 -> node 0"
run -q -n 6 stuck cross
check "of many locks each is told" said "^  cycle: node 0 -> node 1 -> node 2 -> node 3 -> node 4 -> node 5 -> node 0"
for how in start lock; do
    equal_results "a deadlock: $how" -n 2 stuck $how
done

check "mpif90 compiles" bin/mpif90 -O2 -o fortran "$tests/mpi_win.f90"
run -q -m delta -n 4 fortran
check "Fortran's calls" test "$(xargs <out)" = "3 6 0 100 104 32 T"
equal_results "Fortran" -m delta -n 4 fortran

# A program that uses neither files nor windows carries neither.
check "a program without them compiles" bin/mpicc -O2 -o mpi_nodes "$tests/mpi_nodes.c"
nm mpi_nodes >names
check "it has no files and no windows" bash -c 'grep -q PMPI_Allreduce names && ! grep -qE "File_|Win_|file_of|win_of" names'
