/* mpi_wrong.c - wrong calls of MPI, and calls at the wrong time, each by a name. mpi_wrong NAME makes it;
 * with another argument errors are returned, and rank 0 prints the class. */
#include <mpi.h>
#include <stdio.h>
#include <string.h>

enum { MOST = 64 };
static int rank, size, from[MOST], into[MOST], zeros[MOST], ones[MOST];
static MPI_Win win;

#define WRONG(name, expression)                                                                              \
    static int name(void)                                                                                    \
    {                                                                                                        \
        return expression;                                                                                   \
    }

/* Errors of calls that do not send, and of calls that are made of others. */
static MPI_Message none = MPI_MESSAGE_NULL;
static MPI_Datatype type;
static MPI_Request request;
static MPI_Comm comm;
static MPI_Aint place;
WRONG(mrecv, MPI_Mrecv(into, 1, MPI_INT, &none, MPI_STATUS_IGNORE))
WRONG(call_errhandler, MPI_Comm_call_errhandler(MPI_COMM_WORLD, MPI_ERR_COUNT))
WRONG(pack_external, MPI_Pack_external("native", from, 1, MPI_INT, into, 4, &place))
WRONG(win_attach, MPI_Win_attach(win, from, 4))
WRONG(vector, MPI_Type_vector(1, -1, 1, MPI_INT, &type))
WRONG(bcast_init, MPI_Bcast_init(into, -1, MPI_INT, 0, MPI_COMM_WORLD, MPI_INFO_NULL, &request))
WRONG(send_init, MPI_Send_init(from, 1, MPI_INT, size, 0, MPI_COMM_WORLD, &request))
WRONG(isendrecv_replace, MPI_Isendrecv_replace(from, 1, MPI_INT, 0, -1, 0, 0, MPI_COMM_WORLD, &request))
WRONG(split_type, MPI_Comm_split_type(MPI_COMM_NULL, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &comm))
WRONG(dup_with_info, MPI_Comm_dup_with_info(MPI_COMM_NULL, MPI_INFO_NULL, &comm))
WRONG(ineighbor, MPI_Ineighbor_alltoall(from, 1, MPI_INT, into, 1, MPI_INT, MPI_COMM_WORLD, &request))

/* What one rank's own epochs do not allow. */
static int free_locked(void)
{
    MPI_Win_lock(MPI_LOCK_SHARED, size - 1, 0, win);
    return MPI_Win_free(&win);
}
static int fence_locked(void)
{
    MPI_Win_lock_all(0, win);
    return MPI_Win_fence(0, win);
}
static int free_posted(void)
{
    MPI_Group group;
    MPI_Comm_group(MPI_COMM_WORLD, &group);
    MPI_Win_post(group, 0, win);
    return MPI_Win_free(&win);
}

/* Rank 0 is in both groups. */
WRONG(overlap, MPI_Intercomm_create(MPI_COMM_WORLD, 0, MPI_COMM_WORLD, 0, 1, &comm))

/* One buffer for both. */
WRONG(allreduce, MPI_Allreduce(into, into, 2, MPI_INT, MPI_SUM, MPI_COMM_WORLD))
WRONG(iallreduce, MPI_Iallreduce(into, into, 2, MPI_INT, MPI_SUM, MPI_COMM_WORLD, &request))
WRONG(reduce, MPI_Reduce(into, into, 2, MPI_INT, MPI_SUM, 0, MPI_COMM_WORLD))
WRONG(gatherv, rank
                   ? MPI_ERR_BUFFER
                   : MPI_Gatherv(into, 2, MPI_INT, into, ones, (int[MOST]){0, 1}, MPI_INT, 0, MPI_COMM_WORLD))
WRONG(scatterv,
      rank ? MPI_ERR_BUFFER
           : MPI_Scatterv(into, ones, (int[MOST]){0, 1}, MPI_INT, into, 2, MPI_INT, 0, MPI_COMM_WORLD))
WRONG(null_split, MPI_Comm_split(MPI_COMM_WORLD, 0, 0, NULL))
WRONG(null_size, MPI_Group_size(MPI_GROUP_EMPTY, NULL))
WRONG(null_type, MPI_Type_vector(1, 1, 1, MPI_INT, NULL))
WRONG(null_extent, MPI_Type_get_extent(MPI_INT, NULL, NULL))
WRONG(reduce_local, MPI_Reduce_local(MPI_IN_PLACE, into, 2, MPI_INT, MPI_SUM))
WRONG(scan, MPI_Scan(into, into, 2, MPI_INT, MPI_SUM, MPI_COMM_WORLD))
WRONG(reduce_scatter, MPI_Reduce_scatter(into, into, ones, MPI_INT, MPI_SUM, MPI_COMM_WORLD))
WRONG(block, MPI_Reduce_scatter_block(into, into, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD))
WRONG(allgather, MPI_Allgather(into, 1, MPI_INT, into, 1, MPI_INT, MPI_COMM_WORLD))
/* (Of other lengths: an own part that lies in its place is none but where errors are returned.) */
WRONG(gather, MPI_Gather(into, 2, MPI_INT, into, 1, MPI_INT, 0, MPI_COMM_WORLD))
WRONG(scatter, MPI_Scatter(into, 1, MPI_INT, into, 2, MPI_INT, 0, MPI_COMM_WORLD))
WRONG(in_place, MPI_Allgather(&into[rank], 1, MPI_INT, into, 1, MPI_INT, MPI_COMM_WORLD))
WRONG(alltoall, MPI_Alltoall(into, 1, MPI_INT, into, 1, MPI_INT, MPI_COMM_WORLD))
WRONG(alltoallv, MPI_Alltoallv(into, ones, zeros, MPI_INT, into, ones, zeros, MPI_INT, MPI_COMM_WORLD))

/* No errors: nothing is sent; the other buffer does not count; the parts lie apart. */
static int fine(void)
{
    int code = MPI_Isendrecv(from, 1, MPI_INT, MPI_PROC_NULL, 0, into, 1, MPI_INT, MPI_PROC_NULL, 0,
                             MPI_COMM_WORLD, &request),
        apart[MOST];
    code = code ? code : MPI_Wait(&request, MPI_STATUS_IGNORE);
    code = code ? code : MPI_Allreduce(into, into, 0, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    for (int i = 0; i < size; i++)
        apart[i] = size + i;
    code = code ? code : MPI_Reduce(from, rank ? from : into, 1, MPI_INT, MPI_SUM, 0, MPI_COMM_WORLD);
    code =
        code ? code : MPI_Alltoallv(into, zeros, zeros, MPI_INT, into, zeros, zeros, MPI_INT, MPI_COMM_WORLD);
    code =
        code ? code : MPI_Alltoallv(into, ones, zeros, MPI_INT, into, ones, apart, MPI_INT, MPI_COMM_WORLD);
    code = code ? code : MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, win);
    code = code ? code : MPI_Win_unlock(0, win);
    code = code ? code : MPI_Win_lock_all(0, win);
    code = code ? code : MPI_Put(from, 1, MPI_INT, size - 1, 0, 1, MPI_INT, win);
    code = code ? code : MPI_Win_unlock_all(win);
    code = code ? code : MPI_Win_fence(0, win);
    return code ? code : MPI_Win_free(&win);
}

/* One rank's call fails, and is made again: it is the counterpart of the others'. */
static int again(void)
{
    int first = rank ? MPI_SUCCESS : MPI_Bcast(into, -1, MPI_INT, 0, MPI_COMM_WORLD), sum;
    into[0] = rank ? 0 : 7;
    int code = MPI_Bcast(into, 1, MPI_INT, 0, MPI_COMM_WORLD);
    code = code ? code : MPI_Allreduce(into, &sum, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    return code || sum != 7 * size || (!rank && first == MPI_SUCCESS) ? MPI_ERR_OTHER : MPI_SUCCESS;
}

static const struct wrong {
    const char *name;
    int (*call)(void);
} all[] = {{"mrecv", mrecv},
           {"call_errhandler", call_errhandler},
           {"pack_external", pack_external},
           {"win_attach", win_attach},
           {"vector", vector},
           {"bcast_init", bcast_init},
           {"send_init", send_init},
           {"isendrecv_replace", isendrecv_replace},
           {"split_type", split_type},
           {"dup_with_info", dup_with_info},
           {"ineighbor", ineighbor},
           {"free_locked", free_locked},
           {"fence_locked", fence_locked},
           {"free_posted", free_posted},
           {"overlap", overlap},
           {"allreduce", allreduce},
           {"iallreduce", iallreduce},
           {"reduce", reduce},
           {"gatherv", gatherv},
           {"scatterv", scatterv},
           {"null_split", null_split},
           {"null_size", null_size},
           {"null_type", null_type},
           {"null_extent", null_extent},
           {"reduce_local", reduce_local},
           {"scan", scan},
           {"reduce_scatter", reduce_scatter},
           {"block", block},
           {"allgather", allgather},
           {"gather", gather},
           {"scatter", scatter},
           {"in_place", in_place},
           {"again", again},
           {"alltoall", alltoall},
           {"alltoallv", alltoallv},

           {"fine", fine}};

int main(int argc, char **argv)
{
    char text[MPI_MAX_ERROR_STRING];
    int length, code = MPI_ERR_UNKNOWN;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    for (int i = 0; i < MOST; i++)
        ones[i] = 1;
    MPI_Win_create(from, sizeof from, sizeof *from, MPI_INFO_NULL, MPI_COMM_WORLD, &win);
    if (argc > 2) {
        MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
        MPI_Win_set_errhandler(win, MPI_ERRORS_RETURN);
    }
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (argc > 1 && !strcmp(argv[1], all[i].name))
            code = all[i].call();
    MPI_Error_string(code, text, &length);
    if (rank == 0)
        printf("%s\n", text);
    MPI_Finalize();
    return 0;
}
