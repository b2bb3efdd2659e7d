/* mpi_wrong.c - wrong calls of MPI, and calls at the wrong time, each by a name. mpi_wrong NAME makes it;
 * with another argument errors are returned, and rank 0 prints the class. */
#include <mpi.h>
#include <stdbool.h>
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

/* Ranges and lists that are none. */
static MPI_Group world, part;
WRONG(range, MPI_Group_range_incl(world, 2, (int[][3]){{0, 0x7fffffff, 1}, {0, 0x7fffffff, 1}}, &part))
WRONG(group_count, MPI_Group_incl(world, -1, from, &part))
WRONG(lengths, MPI_Type_indexed(2, (int[]){1, -2}, from, MPI_INT, &type))
WRONG(block_length, MPI_Type_create_indexed_block(1, -3, from, MPI_INT, &type))
WRONG(struct_length,
      MPI_Type_create_struct(1, (int[]){-4}, &place, (MPI_Datatype[]){MPI_INT, MPI_INT}, &type))
WRONG(no_dimension, MPI_Type_create_subarray(0, ones, ones, from, MPI_ORDER_C, MPI_INT, &type))
WRONG(other_order, MPI_Type_create_subarray(1, ones, ones, from, 99, MPI_INT, &type))
WRONG(far_start, MPI_Type_create_subarray(1, ones, ones, (int[]){0x7fffffff}, MPI_ORDER_C, MPI_INT, &type))
#define DARRAY(rank, kind, block, parts)                                                                     \
    MPI_Type_create_darray(2, rank, 1, (int[]){10}, (int[]){kind}, (int[]){block}, (int[]){parts},           \
                           MPI_ORDER_C, MPI_INT, &type)
WRONG(no_parts, DARRAY(0, MPI_DISTRIBUTE_BLOCK, MPI_DISTRIBUTE_DFLT_DARG, 0))
WRONG(no_block, DARRAY(0, MPI_DISTRIBUTE_CYCLIC, 0, 2))
WRONG(short_block, DARRAY(0, MPI_DISTRIBUTE_BLOCK, 4, 2))
WRONG(no_kind, DARRAY(0, 77, 5, 2))
WRONG(other_grid, DARRAY(0, MPI_DISTRIBUTE_BLOCK, 5, 3))
WRONG(other_rank, DARRAY(2, MPI_DISTRIBUTE_BLOCK, 5, 2))
WRONG(many_sides, MPI_Dims_create(12, 2, (int[]){65536, 65536}))
WRONG(no_nodes, MPI_Dims_create(0, 2, zeros))
WRONG(large_grid, MPI_Cart_create(MPI_COMM_WORLD, 2, (int[]){65536, 65536}, zeros, 0, &comm))
WRONG(ends, MPI_Graph_create(MPI_COMM_WORLD, 2, (int[]){3, 1}, ones, 0, &comm))
WRONG(sources, MPI_Dist_graph_create_adjacent(MPI_COMM_WORLD, 1, &size, MPI_UNWEIGHTED, 0, NULL,
                                              MPI_UNWEIGHTED, MPI_INFO_NULL, 0, &comm))
WRONG(degrees, MPI_Dist_graph_create(MPI_COMM_WORLD, 1, zeros, (int[]){-1}, zeros, MPI_UNWEIGHTED,
                                     MPI_INFO_NULL, 0, &comm))
WRONG(other_leader, MPI_Intercomm_create(MPI_COMM_SELF, 0, MPI_COMM_WORLD, size, 0, &comm))
WRONG(group_tag, MPI_Comm_create_group(MPI_COMM_WORLD, world, -1, &comm))
WRONG(split_kind, MPI_Comm_split_type(MPI_COMM_WORLD, 77, 0, MPI_INFO_NULL, &comm))
static int two_groups(void)
{
    MPI_Intercomm_create(MPI_COMM_SELF, 0, MPI_COMM_WORLD, 1 - rank, 0, &comm);
    return MPI_Cart_create(comm, 1, ones, zeros, 0, &comm);
}

/* Room, and what is there. */
static int at;
WRONG(pack_room, MPI_Pack(from, 1, MPI_INT, into, -1, &at, MPI_COMM_WORLD))
WRONG(unpack_size, MPI_Unpack(from, -1, &at, into, 1, MPI_INT, MPI_COMM_WORLD))
WRONG(pack_size, MPI_Pack_size(-1, MPI_INT, MPI_COMM_WORLD, &at))
WRONG(pack_count, MPI_Pack_external("external32", from, -1, MPI_INT, into, sizeof into, &place))
static int unpack_place(void)
{
    place = -4;
    return MPI_Unpack_external("external32", from, sizeof from, &place, into, 1, MPI_INT);
}
WRONG(local_count, MPI_Reduce_local(from, into, -1, MPI_INT, MPI_SUM))
WRONG(no_function, MPI_Op_create(NULL, 1, &(MPI_Op){MPI_OP_NULL}))
WRONG(ibsend, MPI_Ibsend(from, 1, MPI_INT, 0, 0, MPI_COMM_WORLD, &request))
static int start_buffered(void)
{
    MPI_Bsend_init(from, 1, MPI_INT, 0, 0, MPI_COMM_WORLD, &request);
    return MPI_Start(&request);
}
WRONG(replace, MPI_Allreduce(from, into, 1, MPI_INT, MPI_REPLACE, MPI_COMM_WORLD))
static int neighbor_type(void)
{
    MPI_Cart_create(MPI_COMM_WORLD, 1, &size, ones, 0, &comm);
    return MPI_Neighbor_alltoall(from, 1, MPI_DATATYPE_NULL, into, 1, MPI_INT, comm);
}
static int neighbor_count(void)
{
    MPI_Cart_create(MPI_COMM_WORLD, 1, &size, ones, 0, &comm);
    return MPI_Neighbor_alltoallv(from, ones, zeros, MPI_INT, into, (int[]){1, -1}, zeros, MPI_INT, comm);
}
static MPI_Request generals[2];
static int wait_general(void)
{
    for (int i = 0; i < 2; i++)
        MPI_Grequest_start(NULL, NULL, NULL, NULL, &generals[i]);
    return MPI_Waitany(2, generals, &at, MPI_STATUS_IGNORE);
}
static int some_general(void)
{
    MPI_Grequest_start(NULL, NULL, NULL, NULL, generals);
    return MPI_Waitsome(1, generals, &at, &at, MPI_STATUSES_IGNORE);
}
static int mrecv_count(void)
{
    MPI_Send(from, 1, MPI_INT, rank, 0, MPI_COMM_WORLD);
    MPI_Mprobe(rank, 0, MPI_COMM_WORLD, &none, MPI_STATUS_IGNORE);
    return MPI_Mrecv(into, -1, MPI_INT, &none, MPI_STATUS_IGNORE);
}
WRONG(no_handler, MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRHANDLER_NULL))
WRONG(free_env, MPI_Info_free(&(MPI_Info){MPI_INFO_ENV}))
static int info_texts(bool key, int room)
{
    MPI_Info info;
    static char text[MPI_MAX_INFO_VAL + 1];
    int flag;
    MPI_Info_create(&info);
    MPI_Info_set(info, "key", "value");
    memset(text, 'x', MPI_MAX_INFO_VAL);
    return room ? MPI_Info_get(info, "key", room, text, &flag)
                : MPI_Info_set(info, key ? text : "key", key ? "value" : text);
}
WRONG(info_key, info_texts(true, 0))
WRONG(info_value, info_texts(false, 0))
WRONG(info_room, info_texts(false, -1))
WRONG(rput_rank, MPI_Rput(from, 1, MPI_INT, 0x3fffffff, 0, 1, MPI_INT, win, &request))
static int rput_fenced(void)
{
    MPI_Win_fence(0, win);
    return MPI_Rput(from, 1, MPI_INT, 0, 0, 1, MPI_INT, win, &request);
}
static int swap_pair(void)
{
    MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, win);
    return MPI_Compare_and_swap(from, from, into, MPI_DOUBLE_INT, 0, 0, win);
}

/* An attribute that may not go, or be copied. */
static int refuses(MPI_Datatype of, int key, void *value, void *extra)
{
    return (void)of, (void)key, (void)value, (void)extra, MPI_ERR_NAME;
}
static int refuses_copy(MPI_Datatype of, int key, void *extra, void *in, void *out, int *flag)
{
    return (void)of, (void)key, (void)extra, (void)in, (void)out, (void)flag, MPI_ERR_NAME;
}
static int set_one(void)
{
    int key;
    MPI_Type_contiguous(2, MPI_INT, &type);
    MPI_Type_create_keyval(refuses_copy, refuses, &key, NULL);
    MPI_Type_set_attr(type, key, NULL);
    return key;
}
static int free_type(void)
{
    set_one();
    return MPI_Type_free(&type);
}
static int dup_type(void)
{
    MPI_Datatype copy;
    set_one();
    return MPI_Type_dup(type, &copy);
}
static int set_again(void)
{
    int key = set_one();
    return MPI_Type_set_attr(type, key, NULL);
}

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

/* A communicator's own handler is told of its attributes; it lasts as long as the communicator. */
static void handler(MPI_Comm *of, int *code, ...)
{
    (void)of, (void)code;
}
static int own_handler(void)
{
    MPI_Fint first = 0;
    int found;
    for (int i = 0; i < 3; i++) {
        MPI_Errhandler own;
        MPI_Comm_dup(MPI_COMM_SELF, &comm);
        MPI_Comm_create_errhandler(handler, &own);
        MPI_Comm_set_errhandler(comm, own);
        first = first ? first : MPI_Errhandler_c2f(own);
        if (MPI_Errhandler_c2f(own) > first ||
            MPI_Comm_get_attr(comm, 12345, &place, &found) != MPI_ERR_KEYVAL)
            return MPI_ERR_OTHER;
        MPI_Errhandler_free(&own);
        MPI_Comm_free(&comm);
    }
    return MPI_SUCCESS;
}

/* Each class has a text; one of the program's is as long as there is room for. */
static int texts(void)
{
    char text[MPI_MAX_ERROR_STRING], longer[2 * MPI_MAX_ERROR_STRING];
    int class, length, found, *last;
    for (int code = MPI_SUCCESS; code <= MPI_ERR_RMA_FLAVOR; code++) {
        MPI_Error_string(code, text, &length);
        if (!strcmp(text, "unknown error code"))
            return MPI_ERR_OTHER;
    }
    memset(longer, 'x', sizeof longer - 1), longer[sizeof longer - 1] = '\0';
    MPI_Add_error_class(&class);
    MPI_Add_error_string(class, longer);
    MPI_Error_string(class, text, &length);
    MPI_Comm_get_attr(MPI_COMM_WORLD, MPI_LASTUSEDCODE, &last, &found);
    return length == (int)strlen(text) && *last == class ? MPI_SUCCESS : MPI_ERR_OTHER;
}

/* Copies of graphs without weights, and with them. */
static int graph_copies(void)
{
    for (int weighted = 0; weighted < 2; weighted++) {
        int next = (rank + 1) % size, before = (rank + size - 1) % size, ins, outs, flag, weights[2] = {0};
        int *given = weighted ? &(int){7} : MPI_UNWEIGHTED;
        MPI_Comm graph;
        MPI_Dist_graph_create_adjacent(MPI_COMM_WORLD, 1, &before, given, 1, &next, given, MPI_INFO_NULL, 0,
                                       &graph);
        MPI_Comm_dup(graph, &comm);
        MPI_Dist_graph_neighbors_count(comm, &ins, &outs, &flag);
        MPI_Dist_graph_neighbors(comm, 1, &ins, weights, 1, &outs, weights + 1);
        if (ins != before || outs != next || flag != weighted || weights[0] != 7 * weighted)
            return MPI_ERR_OTHER;
    }
    return MPI_SUCCESS;
}

/* external32: a complex number is two; a part of an element that has been read is converted, too. */
static int external(void)
{
    static const unsigned char packed[] = {0x3f, 0xf0, 0, 0, 0, 0, 0, 0, 0x40, 0, 0, 0, 0, 0, 0, 0};
    double one_and_two[2] = {1, 2};
    unsigned char bytes[sizeof packed];
    int numbers[4] = {1, 2, 3}, count;
    MPI_File file;
    MPI_Status status;
    MPI_Pack_external("external32", one_and_two, 1, MPI_C_DOUBLE_COMPLEX, bytes, sizeof bytes, &place);
    MPI_Type_contiguous(4, MPI_INT, &type);
    MPI_Type_commit(&type);
    MPI_File_open(MPI_COMM_SELF, rank ? "one" : "zero", MPI_MODE_RDWR | MPI_MODE_CREATE, MPI_INFO_NULL,
                  &file);
    MPI_File_set_view(file, 0, MPI_INT, MPI_INT, "external32", MPI_INFO_NULL);
    MPI_File_write_at(file, 0, numbers, 3, MPI_INT, &status);
    memset(numbers, 0, sizeof numbers);
    MPI_File_read_at(file, 0, numbers, 1, type, &status);
    MPI_File_close(&file);
    MPI_Get_elements(&status, type, &count);
    return !memcmp(bytes, packed, sizeof packed) && numbers[0] == 1 && numbers[2] == 3 && count == 3
               ? MPI_SUCCESS
               : MPI_ERR_OTHER;
}

static int large_pack(void)
{
    int code = MPI_Pack_size(0x7fffffff, MPI_INT, MPI_COMM_WORLD, &at);
    return at == MPI_UNDEFINED ? code : MPI_ERR_OTHER;
}

/* A receive that is freed before its message comes gets it all the same. */
static int freed(void)
{
    MPI_Request requests[2];
    int other = rank ^ 1, right = 0;
    for (int i = 0; i < MOST; i++)
        from[i] = i + 1;
    MPI_Type_vector(4, 1, 2, MPI_INT, &type);
    MPI_Type_commit(&type);
    MPI_Irecv(into, 1, type, other, 1, MPI_COMM_WORLD, &requests[0]);
    MPI_Irecv(into + 8, 4, MPI_INT, other, 2, MPI_COMM_WORLD, &requests[1]);
    MPI_Request_free(&requests[0]);
    MPI_Request_free(&requests[1]);
    MPI_Type_free(&type);
    MPI_Send(from, 4, MPI_INT, other, 1, MPI_COMM_WORLD);
    MPI_Send(from, 4, MPI_INT, other, 2, MPI_COMM_WORLD);
    MPI_Barrier(MPI_COMM_WORLD);
    for (int i = 0; i < 4; i++)
        right += (into[2 * i] == i + 1) + (into[8 + i] == i + 1);
    return right == 8 ? MPI_SUCCESS : MPI_ERR_OTHER;
}

/* A function of the program has the program's stack, also in a collective with a request. */
static void add(void *in, void *inout, int *count, MPI_Datatype *kind)
{
    volatile int copy[50000];
    (void)kind;
    for (int i = 0; i < 50000; i++)
        copy[i] = ((int *)in)[i % *count];
    for (int i = 0; i < *count; i++)
        ((int *)inout)[i] += copy[49999 - 49999 % *count - *count + i];
}

static int large_function(void)
{
    MPI_Op op;
    ones[1] = rank;
    MPI_Op_create(add, 1, &op);
    MPI_Iallreduce(ones, into, 2, MPI_INT, op, MPI_COMM_WORLD, &request);
    MPI_Wait(&request, MPI_STATUS_IGNORE);
    return into[0] == 2 && into[1] == 1 ? MPI_SUCCESS : MPI_ERR_OTHER;
}

/* A million elements that lie together are made one run in no time, and are none if there are no elements. */
static int large_type(void)
{
    MPI_Datatype empty;
    MPI_Aint lb, extent, none_at, none_wide;
    double began = MPI_Wtime();
    MPI_Type_contiguous(10000000, MPI_INT, &type);
    MPI_Type_contiguous(0, MPI_INT, &empty);
    began = MPI_Wtime() - began;
    MPI_Type_get_extent(type, &lb, &extent);
    MPI_Type_get_extent(empty, &none_at, &none_wide);
    return began < 1e-3 && extent == 40000000 && !none_wide ? MPI_SUCCESS : MPI_ERR_OTHER;
}

/* By the names of their functions. */
#define NAMED(f)                                                                                             \
    {                                                                                                        \
#f, f                                                                                                \
    }
static const struct wrong {
    const char *name;
    int (*call)(void);
} all[] = {NAMED(mrecv),          NAMED(call_errhandler),
           NAMED(pack_external),  NAMED(win_attach),
           NAMED(vector),         NAMED(bcast_init),
           NAMED(send_init),      NAMED(isendrecv_replace),
           NAMED(split_type),     NAMED(dup_with_info),
           NAMED(ineighbor),      NAMED(free_locked),
           NAMED(fence_locked),   NAMED(free_posted),
           NAMED(overlap),        NAMED(allreduce),
           NAMED(iallreduce),     NAMED(reduce),
           NAMED(gatherv),        NAMED(scatterv),
           NAMED(null_split),     NAMED(null_size),
           NAMED(null_type),      NAMED(null_extent),
           NAMED(reduce_local),   NAMED(scan),
           NAMED(reduce_scatter), NAMED(block),
           NAMED(allgather),      NAMED(gather),
           NAMED(scatter),        NAMED(in_place),
           NAMED(again),          NAMED(alltoall),
           NAMED(alltoallv),      NAMED(range),
           NAMED(group_count),    NAMED(lengths),
           NAMED(block_length),   NAMED(struct_length),
           NAMED(no_dimension),   NAMED(other_order),
           NAMED(far_start),      NAMED(no_parts),
           NAMED(no_block),       NAMED(short_block),
           NAMED(no_kind),        NAMED(other_grid),
           NAMED(other_rank),     NAMED(many_sides),
           NAMED(no_nodes),       NAMED(large_grid),
           NAMED(ends),           NAMED(sources),
           NAMED(degrees),        NAMED(other_leader),
           NAMED(group_tag),      NAMED(split_kind),
           NAMED(two_groups),     NAMED(pack_room),
           NAMED(unpack_size),    NAMED(pack_size),
           NAMED(pack_count),     NAMED(unpack_place),
           NAMED(local_count),    NAMED(no_function),
           NAMED(ibsend),         NAMED(start_buffered),
           NAMED(replace),        NAMED(neighbor_type),
           NAMED(neighbor_count), NAMED(wait_general),
           NAMED(some_general),   NAMED(freed),
           NAMED(large_function), NAMED(large_type),
           NAMED(mrecv_count),    NAMED(no_handler),
           NAMED(free_env),       NAMED(info_key),
           NAMED(info_value),     NAMED(info_room),
           NAMED(rput_rank),      NAMED(rput_fenced),
           NAMED(swap_pair),      NAMED(free_type),
           NAMED(dup_type),       NAMED(set_again),
           NAMED(own_handler),    NAMED(texts),
           NAMED(graph_copies),   NAMED(external),
           NAMED(large_pack),     NAMED(fine)};

int main(int argc, char **argv)
{
    char text[MPI_MAX_ERROR_STRING];
    int length, code = MPI_ERR_UNKNOWN;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    for (int i = 0; i < MOST; i++)
        ones[i] = 1;
    MPI_Comm_group(MPI_COMM_WORLD, &world);
    MPI_Win_create(from, sizeof from, sizeof *from, MPI_INFO_NULL, MPI_COMM_WORLD, &win);
    if (argc > 2) {
        MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
        MPI_Comm_set_errhandler(MPI_COMM_SELF, MPI_ERRORS_RETURN);
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
