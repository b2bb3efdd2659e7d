#!/bin/bash
# mpi_nodes.sh - MPI programs on simulated nodes: compiled by mpicc and mpif90, equal in both engines and with all workers; what reports
# say of them; doc/mpi-programs.md.
. "$(dirname "$0")/common.bash"
page=$tests/../../doc/mpi-programs.md

"$BUILD/nxcc" --as-mpi bin >links
check "nxcc makes links by the names of MPI's compilers" grep -q "^bin/mpif90 -> .*/nxcc$" links
check "mpicc compiles" bin/mpicc -O2 -g -Wall -o mpi_nodes "$tests/mpi_nodes.c"
asked() { bin/mpif90 "$1" >answer && [ "$(cat answer)" = "$2" ]; }
node=$(cd "$BUILD/node" && pwd)
check "build systems that ask what is behind mpif90 are told mpif90, and MPI's folders" \
    asked -show "bin/mpif90 -I$node/mpi_include -L$node -lmpi"
check "compiling" asked -showme:compile "-I$node/mpi_include"
check "and linking" asked -showme:link "-L$node -lmpi"
"$BUILD/nxcc" -O2 -o again "$tests/mpi_nodes.c" 2>err
check "nxcc alone says what it needs for MPI" said '^nxcc: nodes do not have .*: -lmpi links'
check "nxcc -lmpi is the same" "$BUILD/nxcc" -O2 -g -Wall -o again "$tests/mpi_nodes.c" -lmpi
check "and gives the same program" cmp mpi_nodes again
check "as a build system does that gives folders and file" \
    "$BUILD/nxcc" -O2 -g -Wall "-I$node/mpi_include" -o again "$tests/mpi_nodes.c" "$node/libmpi.a"
run -q -m delta -n 4 again
check "a program that runs" test "$status" = 0

for n in 4 9 16; do
    run -q -m delta -n $n mpi_nodes
    check "on $n nodes of the delta all holds" test "$status:$(grep -c ': yes$' out):$(grep -c NO out)" = 0:10:0
    equal_results "$n nodes of the delta" -m delta -n $n mpi_nodes
done
equal_results "12 nodes of the paragon" -m paragon -n 12 mpi_nodes
equal_results "no send is eager" -m delta -n 8 --set mpi_eager_limit=0 mpi_nodes
# Twelve ranks are no power of two.
run -q -m delta -n 12 --set mpi_collectives=1995 mpi_nodes
check "with the collectives of 1995 all holds" test "$status:$(grep -c ': yes$' out):$(grep -c NO out)" = 0:10:0
equal_results "collectives of 1995" -m delta -n 12 --set mpi_collectives=1995 mpi_nodes
run -q -m delta -n 12 --set mpi_collectives=2000 mpi_nodes
check "those of another year are refused" said 'mpi_collectives.* must be 1995 or 2005'
check "mpif90 compiles" bin/mpif90 -O2 -o ring "$tests/mpi_nodes.f90"
run -q -n 6 ring
check "Fortran's calls" grep -qx '  4  4  9  15.0  2  1' out
check "none is wrong" eval '! grep -q wrong out'
equal_results "Fortran" -n 6 ring

check "mpif90 compiles later calls" bin/mpif90 -O2 -o more "$tests/mpi_more.f90"
run -q -m delta -n 4 more
check "they work from Fortran" test "$status:$(cat out)" = 0:done
equal_results "Fortran's later calls" -m delta -n 5 more
nm "$BUILD/node/libmpi.a" | sed -nE 's/.* [TW] MPI_(.*)$/\1/p' | grep -vE 'c2f|f2c' | tr A-Z a-z | sort >in_c
nm "$BUILD/node/libmpi.a" | sed -nE 's/.* [TW] mpi_(.*)_$/\1/p' | sort >in_fortran
check "Fortran has all calls" test "$(comm -23 in_c in_fortran | xargs)" = ""

run -q -n 4 mpi_nodes rank
check "a rank that is none ends the run with the call and the ranks" said 'MPI_Send: there is no rank 4 in the communicator \(ranks are 0 to 3\)'
check "and with the line of the program" said 'mpi_nodes\.c:[0-9]+'
run -q -n 4 mpi_nodes context
check "communicators whose numbers are used up end the run" said 'number is too large: with 4 processes, each can begin 266338303 '
echo '#include <mpi.h>
int main(void) { MPI_Comm c; return MPI_Comm_dup(MPI_COMM_WORLD, &c); }' >early.c
sed 's/MPI_Comm_dup(.*)/MPI_Attr_put(MPI_COMM_WORLD, 1, \&c)/' early.c >rare.c
for program in early rare; do
    bin/mpicc -o $program $program.c && run -q -n 1 $program
    check "$program: a call before MPI_Init" said 's: MPI[A-Za-z_]*: called before MPI_Init'
done
echo '#include <mpi.h>
int main(int argc, char **argv)
{
    int rank = 0;
    MPI_Comm graph;
    MPI_Init(&argc, &argv);
    MPI_Dist_graph_create_adjacent(MPI_COMM_WORLD, 1, &rank, MPI_UNWEIGHTED, 1, &rank, MPI_UNWEIGHTED, MPI_INFO_NULL, 0, &graph);
    MPI_Dist_graph_neighbors(graph, 1, &rank, MPI_UNWEIGHTED, 1, &rank, MPI_UNWEIGHTED);
    if (argc > 2)
        return MPI_Allgatherv(&argc, 1, MPI_INT, (int[2]){0}, (int[]){1, -1}, (int[]){0, 1}, MPI_INT, MPI_COMM_WORLD);
    return argc > 1 ? MPI_Comm_size(MPI_COMM_NULL, &rank) : MPI_Waitall(-1, NULL, MPI_STATUSES_IGNORE);
}' >null.c
check "MPI_UNWEIGHTED gives no warnings" bin/mpicc -O2 -Wall -Wextra -Werror -o null null.c
run -q -n 1 null size
check "a null communicator: the call that core does not know, too" said 's: MPI_Comm_size: the communicator is null, or freed'
run -q -n 1 null
check "a negative count of requests" said 'a count is negative'
run -q -n 2 null size each
check "one of a list of counts is negative" said 's: MPI_Allgatherv: a count is negative'
check "none is called MPI_Other" eval '! said Other'
run -q -n 4 mpi_nodes long
check "a message too long: both lengths" said 'MPI_Recv: the message of tag 9 from rank 0 has 9 bytes, but the buffer only 2'

# The page.
block "$page" c >heat.c
block "$page" c 2 >unsafe.c
block "$page" out >expected
ln -s "$BUILD" build
PATH=$BUILD:$PATH
rm -rf bin
check "the page's first commands" bash -e -c "$(block "$page" sh) >said"
check "give what it says" cmp said expected
PATH=$PWD/bin:$PATH
mpirun -np 4 ./heat >out 2>err
check "bin's mpirun: on simulated nodes" grep -q '^4 ranks: ' out
TOUCHSTONE_RUN="-m ipsc860 -n 2" mpiexec --oversubscribe -n 8 ./heat >out 2>err
check "bin's mpiexec: its number of ranks over that of TOUCHSTONE_RUN" grep -q '^8 ranks: ' out
check "the trace says what the ranks waited for" bash -e -c "$(block "$page" sh 2)"
bash -c "$(block "$page" sh 3)" >out 2>err
check "with mpi_eager_limit 0 the unsafe program is found, as the page says" cmp err <(block "$page" err)

# What the tools say.
block "$page" c 3 >hasty.c
bash -c "$(block "$page" sh 4)" >out 2>err
check "--mpi-checks says what the page says" cmp err <(block "$page" err 2)
bash -c "$(block "$page" sh 5)" >out 2>err
check "so does --races" cmp out <(block "$page" out 2)
