#!/bin/bash
# mpi_wrong.sh - wrong calls of MPI on simulated nodes: the error names the call that the program made, node and line; and is returned by
# its class where errors are returned.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"

"$BUILD/nxcc" --as-mpi bin >links
check "mpicc compiles" bin/mpicc -O0 -g -Wall -o mpi_wrong "$tests/mpi_wrong.c"
while IFS='|' read -r how class call error; do
    run -q -n 2 mpi_wrong "$how"
    check "$how: the call and the error" said "node [01], at [0-9.]+ [mun]?s: $call: $error"
    check "$how: the line" said "called from $how.*\(mpi_wrong\.c:[0-9]+\)"
    run -q -n 2 mpi_wrong "$how" returned
    check "$how: the class is returned" test "$(head -1 out)" = "$class"
done <<'END'
mrecv|invalid request|MPI_Mrecv|the message is null
call_errhandler|no error|MPI_Comm_call_errhandler|invalid count
pack_external|invalid argument|MPI_Pack_external|there is the representation external32 only
win_attach|not for windows of this kind|MPI_Win_attach|the window is not a dynamic one
vector|invalid count|MPI_Type_vector|the count -1 is negative
bcast_init|invalid count|MPI_Bcast_init|the count -1 is negative
send_init|invalid rank|MPI_Send_init|there is no rank 2
isendrecv_replace|invalid tag|MPI_Isendrecv_replace|tag -1 is out of range
split_type|invalid communicator|MPI_Comm_split_type|the communicator is null
dup_with_info|invalid communicator|MPI_Comm_dup_with_info|the communicator is null
ineighbor|invalid topology|MPI_Ineighbor_alltoall|the communicator has neither a grid
free_locked|the window may not be used at this time|MPI_Win_free|an epoch of MPI_Win_lock goes on
fence_locked|the window may not be used at this time|MPI_Win_fence|an epoch of MPI_Win_lock_all goes on
free_posted|the window may not be used at this time|MPI_Win_free|an epoch of MPI_Win_post goes on
overlap|invalid communicator|MPI_Intercomm_create|rank [01] is in both groups
allreduce|invalid buffer|MPI_Allreduce|what is sent and what is received
iallreduce|invalid buffer|MPI_Iallreduce|what is sent and what is received
reduce|invalid buffer|MPI_Reduce|what is sent and what is received
gatherv|invalid buffer|MPI_Gatherv|what is sent and what is received
scatterv|invalid buffer|MPI_Scatterv|what is sent and what is received
null_split|invalid argument|MPI_Comm_split|the pointer to where the answer goes is null
null_size|invalid argument|MPI_Group_size|the pointer to where the answer goes is null
null_type|invalid argument|MPI_Type_vector|the pointer to where the answer goes is null
null_extent|invalid argument|MPI_Type_get_extent|the pointer to where the answer goes is null
reduce_local|invalid buffer|MPI_Reduce_local|MPI_IN_PLACE is no buffer of this call
scan|invalid buffer|MPI_Scan|what is sent and what is received
reduce_scatter|invalid buffer|MPI_Reduce_scatter|what is sent and what is received
block|invalid buffer|MPI_Reduce_scatter_block|what is sent and what is received
allgather|invalid buffer|MPI_Allgather|what is sent and what is received
gather|invalid buffer|MPI_Gather|what is sent and what is received
scatter|invalid buffer|MPI_Scatter|what is sent and what is received
alltoall|invalid buffer|MPI_Alltoall|what is sent and what is received
alltoallv|invalid buffer|MPI_Alltoallv|what is sent and what is received
range|invalid rank|MPI_Group_range_incl|rank [02] is
group_count|invalid argument|MPI_Group_incl|the count -1 is negative
lengths|invalid count|MPI_Type_indexed|the count -2 is negative
block_length|invalid count|MPI_Type_create_indexed_block|the count -3 is negative
struct_length|invalid count|MPI_Type_create_struct|the count -4 is negative
no_dimension|invalid argument|MPI_Type_create_subarray|0 dimensions, in order 12
other_order|invalid argument|MPI_Type_create_subarray|1 dimensions, in order 99
far_start|invalid argument|MPI_Type_create_subarray|dimension 0 has 1 elements; 1 from 2147483647 on
no_parts|invalid argument|MPI_Type_create_darray|dimension 0: 10 elements cannot be shared out in kind 17, by blocks of 19, among 0
no_block|invalid argument|MPI_Type_create_darray|dimension 0: 10 elements cannot be shared out in kind 18, by blocks of 0, among 2
short_block|invalid argument|MPI_Type_create_darray|dimension 0: 10 elements cannot be shared out in kind 17, by blocks of 4, among 2
no_kind|invalid argument|MPI_Type_create_darray|dimension 0: 10 elements cannot be shared out in kind 77
other_grid|invalid argument|MPI_Type_create_darray|rank 0 of 2, which the grid does not have
other_rank|invalid argument|MPI_Type_create_darray|rank 2 of 2, which the grid does not have
many_sides|invalid dimensions|MPI_Dims_create|12 nodes are no multiple of the 65536 that
no_nodes|invalid dimensions|MPI_Dims_create|0 nodes in 2 dimensions
large_grid|invalid dimensions|MPI_Cart_create|the grid has 4294967296 ranks, the communicator 2
ends|invalid argument|MPI_Graph_create|node 1's edges end before they begin, at 1
sources|invalid rank|MPI_Dist_graph_create_adjacent|there is no rank 2 in the communicator
degrees|invalid argument|MPI_Dist_graph_create|the count -1 is negative
other_leader|invalid rank|MPI_Intercomm_create|the other leader 2 is not one of 2 ranks
group_tag|invalid tag|MPI_Comm_create_group|the tag -1 is negative
split_kind|invalid argument|MPI_Comm_split_type|there is no kind of part 77
two_groups|invalid communicator|MPI_Cart_create|not for communicators of two groups
pack_room|the message is longer than the receive|MPI_Pack|1 elements of 4 bytes do not fit into -1 bytes
unpack_size|the message is longer than the receive|MPI_Unpack|there are fewer than 1 elements of 4 bytes in -1 bytes
pack_size|invalid count|MPI_Pack_size|the count -1 is negative
pack_count|invalid count|MPI_Pack_external|the count -1 is negative
unpack_place|the message is longer than the receive|MPI_Unpack_external|fewer than 4 bytes are there after position -4
local_count|invalid count|MPI_Reduce_local|the count -1 is negative
no_function|invalid argument|MPI_Op_create|the function is a null pointer
ibsend|invalid buffer|MPI_Ibsend|4 bytes and MPI_BSEND_OVERHEAD do not fit
start_buffered|invalid buffer|MPI_Start|4 bytes and MPI_BSEND_OVERHEAD do not fit
replace|invalid operation|MPI_Allreduce|the operation is for accesses to windows only
neighbor_type|invalid datatype|MPI_Neighbor_alltoall|the datatype is null
neighbor_count|invalid count|MPI_Neighbor_alltoallv|the count -1 is negative
wait_general|invalid request|MPI_Waitany|a generalized request is waited for
some_general|invalid request|MPI_Waitsome|a generalized request is waited for
mrecv_count|invalid count|MPI_Mrecv|the count -1 is negative
no_handler|invalid argument|MPI_Comm_set_errhandler|the error handler is null
free_env|invalid info|MPI_Info_free|the info is null
info_key|invalid key of an info|MPI_Info_set|the key is empty, or longer than 255 letters
info_value|invalid value of an info|MPI_Info_set|the value is longer than 1023 letters
info_room|invalid argument|MPI_Info_get|room for -1 letters
rput_rank|invalid rank|MPI_Rput|there is no rank 1073741823 in the window
rput_fenced|the window may not be used at this time|MPI_Rput|rank 0 is accessed with a request before MPI_Win_lock
swap_pair|invalid operation|MPI_Compare_and_swap|what is compared is an integer, a logical or a byte
free_type|no such name of a service|MPI_Type_free|an attribute's delete function says no
dup_type|no such name of a service|MPI_Type_dup|an attribute's copy function says no
set_again|no such name of a service|MPI_Type_set_attr|an attribute's delete function says no
END
for right in own_handler texts graph_copies external large_pack freed large_function large_type; do
    run -q -n 2 mpi_wrong $right
    check "$right: all is as it should be" test "$status:$(cat out)" = "0:no error"
done
run -q -n 2 mpi_wrong in_place returned
check "an own part in its place is an error where errors are returned" test "$(head -1 out)" = "invalid buffer"
run -q -n 2 mpi_wrong in_place
check "and none where they end the run" test "$status:$(head -1 out)" = "0:no error"
run -q -n 4 mpi_wrong again returned
check "a collective that failed on one rank may be called again" test "$status:$(head -1 out)" = "0:no error"
run -q -n 4 mpi_wrong fine
check "what only looks wrong is no error" test "$status:$(cat out)" = "0:no error"
equal_results "the errors" -n 4 mpi_wrong overlap

# What main returns, or STOP: of an MPI program it is its status, as mpirun's; of an old NX program nothing.
cat >returns.c <<'END'
#include <mpi.h>
int main(int argc, char **argv)
{
    int rank;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Finalize();
    return rank == 1 ? 3 : 0;
}
END
check "a program whose main returns 3 compiles" bin/mpicc -g -o returns returns.c
run -q -n 4 returns
check "what main returned is an exit, with main's line" test "$status:$(sed 's/at [0-9.]* us/at T/' err)" = \
    "1:touchstone run: node 1 ended at T with exit(3) (returns.c:3)"
equal_results "main returns 3" -n 4 returns
run -q -n 1 returns
check "0 is none" ended_with 0
echo 'int main(void) { return 3; }' >returns_nx.c
"$BUILD/nxcc" -o returns_nx returns_nx.c && run -q -n 1 returns_nx
check "main of an NX program tells of no error" ended_with 0

cp returns_nx.c tool.c && bin/mpicc -o tool tool.c && run -q -n 1 tool
check "main of a program that mpicc made does, also if it makes no call of MPI" ended_with 1

cat >own.c <<'END'
#include <mpi.h>
int comm_world = 5, get_memory;
int fail(int x) { return x + comm_world; }
int main(int argc, char **argv)
{
    MPI_Init(&argc, &argv);
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Finalize();
    return fail(0) - 5 + get_memory;
}
END
check "a program may have functions and variables by names that the library has inside" bin/mpicc -o own own.c
run -q -n 2 own
check "and both work" ended_with 0

# A rank that ends early: who is behind it in a collective is not told to look at the order of collectives.
sed 's/return rank == 1.*/return 0;/; s/MPI_Finalize/if (rank == 1) exit(1);\n    MPI_Barrier(MPI_COMM_WORLD);\n    &/; s/mpi.h>/&\n#include <stdlib.h>/' returns.c >leaves.c
check "a program one rank of which leaves compiles" bin/mpicc -g -o leaves leaves.c
run -q -n 4 leaves
check "a rank that left is the cause" said '^    Look at node 1 first: its program ended with exit\(1\)'
check "and nothing else is" [ "$(grep -c 'behind others:' err):$(grep -c 'All ranks of a communicator' err)" = 1:0 ]
