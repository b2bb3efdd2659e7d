/* messages.c - Fortran's names for point to point, requests and collectives. */
#include "fortran.h"

/* Tentative, as Fortran's own: the linker makes one of each. */
f_int mpi_fortran_in_place_, mpi_fortran_bottom_, mpi_fortran_unweighted_, mpi_fortran_weights_empty_;
f_int mpi_fortran_status_ignore_[8], mpi_fortran_statuses_ignore_[8];

f_int f_no_ierr;

/* --- point to point --- */

#define SEND(name, c_name)                                                                                   \
    FORTRAN(name, (void *buf, f_int *count, f_int *type, f_int *dest, f_int *tag, f_int *comm, f_int *ierr)) \
    {                                                                                                        \
        IERR = MPI_##c_name(f_buffer(buf), *count, F_TYPE(type), *dest, *tag, F_COMM(comm));                 \
    }
#define SEND_WITH(name, c_name)                                                                              \
    FORTRAN(name, (void *buf, f_int *count, f_int *type, f_int *dest, f_int *tag, f_int *comm,               \
                   f_int *request, f_int *ierr))                                                             \
    {                                                                                                        \
        WITH(MPI_Request, request,                                                                           \
             MPI_##c_name(f_buffer(buf), *count, F_TYPE(type), *dest, *tag, F_COMM(comm), &handle));         \
    }
SEND(send, Send)
SEND(bsend, Bsend)
SEND(ssend, Ssend)
SEND(rsend, Rsend)
SEND_WITH(isend, Isend)
SEND_WITH(ibsend, Ibsend)
SEND_WITH(issend, Issend)
SEND_WITH(irsend, Irsend)
SEND_WITH(send_init, Send_init)
SEND_WITH(bsend_init, Bsend_init)
SEND_WITH(ssend_init, Ssend_init)
SEND_WITH(rsend_init, Rsend_init)
SEND_WITH(irecv, Irecv)
SEND_WITH(recv_init, Recv_init)

FORTRAN(recv, (void *buf, f_int *count, f_int *type, f_int *source, f_int *tag, f_int *comm, f_int *status,
               f_int *ierr))
{
    IERR = MPI_Recv(buf, *count, F_TYPE(type), *source, *tag, F_COMM(comm), f_status(status));
}

FORTRAN(sendrecv, (void *buf, f_int *count, f_int *type, f_int *dest, f_int *tag, void *into, f_int *room,
                   f_int *as, f_int *source, f_int *select, f_int *comm, f_int *status, f_int *ierr))
{
    IERR = MPI_Sendrecv(buf, *count, F_TYPE(type), *dest, *tag, into, *room, F_TYPE(as), *source, *select,
                        F_COMM(comm), f_status(status));
}

FORTRAN(sendrecv_replace, (void *buf, f_int *count, f_int *type, f_int *dest, f_int *tag, f_int *source,
                           f_int *select, f_int *comm, f_int *status, f_int *ierr))
{
    IERR = MPI_Sendrecv_replace(buf, *count, F_TYPE(type), *dest, *tag, *source, *select, F_COMM(comm),
                                f_status(status));
}

FORTRAN(isendrecv, (void *buf, f_int *count, f_int *type, f_int *dest, f_int *tag, void *into, f_int *room,
                    f_int *as, f_int *source, f_int *select, f_int *comm, f_int *request, f_int *ierr))
{
    NEW(MPI_Request, request,
        MPI_Isendrecv(buf, *count, F_TYPE(type), *dest, *tag, into, *room, F_TYPE(as), *source, *select,
                      F_COMM(comm), &made));
}

FORTRAN(isendrecv_replace, (void *buf, f_int *count, f_int *type, f_int *dest, f_int *tag, f_int *source,
                            f_int *select, f_int *comm, f_int *request, f_int *ierr))
{
    NEW(MPI_Request, request,
        MPI_Isendrecv_replace(buf, *count, F_TYPE(type), *dest, *tag, *source, *select, F_COMM(comm), &made));
}

FORTRAN(buffer_attach, (void *buf, f_int *size, f_int *ierr))
{
    IERR = MPI_Buffer_attach(buf, *size);
}

FORTRAN(buffer_detach, (void *buf, f_int *size, f_int *ierr))
{
    void *attached;
    (void)buf;
    IERR = MPI_Buffer_detach(&attached, size);
}

FORTRAN(probe, (f_int * source, f_int *tag, f_int *comm, f_int *status, f_int *ierr))
{
    IERR = MPI_Probe(*source, *tag, F_COMM(comm), f_status(status));
}

FORTRAN(iprobe, (f_int * source, f_int *tag, f_int *comm, f_int *flag, f_int *status, f_int *ierr))
{
    IERR = MPI_Iprobe(*source, *tag, F_COMM(comm), flag, f_status(status));
}

FORTRAN(get_count, (f_int * status, f_int *type, f_int *count, f_int *ierr))
{
    IERR = MPI_Get_count((MPI_Status *)status, F_TYPE(type), count);
}

FORTRAN(get_elements, (f_int * status, f_int *type, f_int *count, f_int *ierr))
{
    IERR = MPI_Get_elements((MPI_Status *)status, F_TYPE(type), count);
}

FORTRAN(get_elements_x, (f_int * status, f_int *type, MPI_Count *count, f_int *ierr))
{
    IERR = MPI_Get_elements_x((MPI_Status *)status, F_TYPE(type), count);
}

FORTRAN(test_cancelled, (f_int * status, f_int *flag, f_int *ierr))
{
    IERR = MPI_Test_cancelled((MPI_Status *)status, flag);
}

/* --- requests --- */

static MPI_Request *requests_of(const f_int *list, f_int count)
{
    MPI_Request *r = get_memory(((size_t)count + 1) * sizeof *r);
    for (f_int i = 0; i < count; i++)
        r[i] = F_HANDLE(MPI_Request, list[i]);
    return r;
}

static void give_requests(MPI_Request *r, f_int *list, f_int count)
{
    for (f_int i = 0; i < count; i++)
        list[i] = F_OF(r[i]);
    free(r);
}

/* Fortran's places begin with 1. */
static void count_from_one(f_int *index)
{
    if (*index != MPI_UNDEFINED)
        ++*index;
}

FORTRAN(wait, (f_int * request, f_int *status, f_int *ierr))
{
    WITH(MPI_Request, request, MPI_Wait(&handle, f_status(status)));
}

FORTRAN(test, (f_int * request, f_int *flag, f_int *status, f_int *ierr))
{
    WITH(MPI_Request, request, MPI_Test(&handle, flag, f_status(status)));
}

FORTRAN(waitall, (f_int * count, f_int *list, f_int *statuses, f_int *ierr))
{
    MPI_Request *r = requests_of(list, *count);
    IERR = MPI_Waitall(*count, r, f_status(statuses));
    give_requests(r, list, *count);
}

FORTRAN(testall, (f_int * count, f_int *list, f_int *flag, f_int *statuses, f_int *ierr))
{
    MPI_Request *r = requests_of(list, *count);
    IERR = MPI_Testall(*count, r, flag, f_status(statuses));
    give_requests(r, list, *count);
}

FORTRAN(waitany, (f_int * count, f_int *list, f_int *index, f_int *status, f_int *ierr))
{
    MPI_Request *r = requests_of(list, *count);
    IERR = MPI_Waitany(*count, r, index, f_status(status));
    give_requests(r, list, *count);
    count_from_one(index);
}

FORTRAN(testany, (f_int * count, f_int *list, f_int *index, f_int *flag, f_int *status, f_int *ierr))
{
    MPI_Request *r = requests_of(list, *count);
    IERR = MPI_Testany(*count, r, index, flag, f_status(status));
    give_requests(r, list, *count);
    count_from_one(index);
}

#define SOME(name, c_name)                                                                                   \
    FORTRAN(name,                                                                                            \
            (f_int * count, f_int * list, f_int * done, f_int * indices, f_int * statuses, f_int * ierr))    \
    {                                                                                                        \
        MPI_Request *r = requests_of(list, *count);                                                          \
        IERR = MPI_##c_name(*count, r, done, indices, f_status(statuses));                                   \
        give_requests(r, list, *count);                                                                      \
        for (f_int i = 0; i < *done; i++)                                                                    \
            indices[i]++;                                                                                    \
    }
SOME(waitsome, Waitsome)
SOME(testsome, Testsome)

FORTRAN(start, (f_int * request, f_int *ierr))
{
    WITH(MPI_Request, request, MPI_Start(&handle));
}

FORTRAN(startall, (f_int * count, f_int *list, f_int *ierr))
{
    MPI_Request *r = requests_of(list, *count);
    IERR = MPI_Startall(*count, r);
    give_requests(r, list, *count);
}

FORTRAN(request_free, (f_int * request, f_int *ierr))
{
    WITH(MPI_Request, request, MPI_Request_free(&handle));
}

FORTRAN(cancel, (f_int * request, f_int *ierr))
{
    WITH(MPI_Request, request, MPI_Cancel(&handle));
}

/* --- collectives: each, the one with a request, and the persistent one --- */

#define COLL(name, c_name, parameters, arguments)                                                            \
    FORTRAN(name, (LIST parameters, f_int * comm, f_int * ierr))                                             \
    {                                                                                                        \
        IERR = MPI_##c_name(LIST arguments, F_COMM(comm));                                                   \
    }                                                                                                        \
    FORTRAN(i##name, (LIST parameters, f_int * comm, f_int * request, f_int * ierr))                         \
    {                                                                                                        \
        WITH(MPI_Request, request, MPI_I##name(LIST arguments, F_COMM(comm), &handle));                      \
    }                                                                                                        \
    FORTRAN(name##_init, (LIST parameters, f_int * comm, f_int * info, f_int * request, f_int * ierr))       \
    {                                                                                                        \
        NEW(MPI_Request, request,                                                                            \
            MPI_##c_name##_init(LIST arguments, F_COMM(comm), F_HANDLE(MPI_Info, *info), &made));            \
    }
#define LIST(...) __VA_ARGS__
#define FROM void *buf, f_int *count, f_int *type
#define INTO void *into, f_int *room, f_int *as
#define GIVES f_buffer(buf), *count, F_TYPE(type)
#define GETS f_buffer(into), *room, F_TYPE(as)
#define FROM_EACH void *buf, f_int *counts, f_int *at, f_int *type
#define INTO_EACH void *into, f_int *rooms, f_int *places, f_int *as
#define GIVES_EACH f_buffer(buf), counts, at, F_TYPE(type)
#define GETS_EACH into, rooms, places, F_TYPE(as)

FORTRAN(barrier, (f_int * comm, f_int *ierr))
{
    IERR = MPI_Barrier(F_COMM(comm));
}

FORTRAN(ibarrier, (f_int * comm, f_int *request, f_int *ierr))
{
    WITH(MPI_Request, request, MPI_Ibarrier(F_COMM(comm), &handle));
}

FORTRAN(barrier_init, (f_int * comm, f_int *info, f_int *request, f_int *ierr))
{
    NEW(MPI_Request, request, MPI_Barrier_init(F_COMM(comm), F_HANDLE(MPI_Info, *info), &made));
}

COLL(bcast, Bcast, (FROM, f_int *root), (buf, *count, F_TYPE(type), *root))
COLL(gather, Gather, (FROM, INTO, f_int *root), (GIVES, GETS, *root))
COLL(gatherv, Gatherv, (FROM, INTO_EACH, f_int *root), (GIVES, GETS_EACH, *root))
COLL(scatter, Scatter, (FROM, INTO, f_int *root), (GIVES, GETS, *root))
COLL(scatterv, Scatterv, (FROM_EACH, INTO, f_int *root), (GIVES_EACH, GETS, *root))
COLL(allgather, Allgather, (FROM, INTO), (GIVES, GETS))
COLL(allgatherv, Allgatherv, (FROM, INTO_EACH), (GIVES, GETS_EACH))
COLL(alltoall, Alltoall, (FROM, INTO), (GIVES, GETS))
COLL(alltoallv, Alltoallv, (FROM_EACH, INTO_EACH), (GIVES_EACH, GETS_EACH))

#define OPERANDS void *buf, void *into, f_int *count, f_int *type, f_int *op
#define GIVEN f_buffer(buf), into, *count, F_TYPE(type), F_HANDLE(MPI_Op, *op)
COLL(reduce, Reduce, (OPERANDS, f_int *root), (GIVEN, *root))
COLL(allreduce, Allreduce, (OPERANDS), (GIVEN))
COLL(scan, Scan, (OPERANDS), (GIVEN))
COLL(exscan, Exscan, (OPERANDS), (GIVEN))
COLL(reduce_scatter_block, Reduce_scatter_block, (OPERANDS), (GIVEN))
COLL(reduce_scatter, Reduce_scatter, (void *buf, void *into, f_int *counts, f_int *type, f_int *op),
     (f_buffer(buf), into, counts, F_TYPE(type), F_HANDLE(MPI_Op, *op)))

/* A list has a datatype for each rank. (A communicator that is none is for the call to refuse.) */
static int ranks_of(MPI_Comm comm)
{
    const struct comm *c = comm_of(comm);
    return c ? c->peers->size : 0;
}

#define EACH                                                                                                 \
    void *buf, f_int *counts, f_int *at, f_int *types, void *into, f_int *rooms, f_int *places, f_int *as,   \
        f_int *comm
#define GIVE_EACH f_buffer(buf), counts, at, list, into, rooms, places, list + ranks, F_COMM(comm)

FORTRAN(alltoallw, (EACH, f_int *ierr))
{
    int ranks = ranks_of(F_COMM(comm));
    MPI_Datatype *list = f_both_types(types, ranks, as, ranks);
    IERR = MPI_Alltoallw(GIVE_EACH);
    free(list);
}

FORTRAN(ialltoallw, (EACH, f_int *request, f_int *ierr))
{
    int ranks = ranks_of(F_COMM(comm));
    MPI_Datatype *list = f_both_types(types, ranks, as, ranks);
    NEW_WITH_LIST(request, list, MPI_Ialltoallw(GIVE_EACH, &made));
}

FORTRAN(alltoallw_init, (EACH, f_int *info, f_int *request, f_int *ierr))
{
    int ranks = ranks_of(F_COMM(comm));
    MPI_Datatype *list = f_both_types(types, ranks, as, ranks);
    NEW(MPI_Request, request, MPI_Alltoallw_init(GIVE_EACH, F_HANDLE(MPI_Info, *info), &made));
    free(list);
}

FORTRAN(reduce_local, (void *in, void *inout, f_int *count, f_int *type, f_int *op, f_int *ierr))
{
    IERR = MPI_Reduce_local(in, inout, *count, F_TYPE(type), F_HANDLE(MPI_Op, *op));
}

FORTRAN(op_commutative, (f_int * op, f_int *commutes, f_int *ierr))
{
    IERR = MPI_Op_commutative(F_HANDLE(MPI_Op, *op), commutes);
}

FORTRAN(op_create, (MPI_User_function * function, f_int *commutes, f_int *op, f_int *ierr))
{
    WITH(MPI_Op, op, MPI_Op_create(function, *commutes, &handle));
}

FORTRAN(op_free, (f_int * op, f_int *ierr))
{
    WITH(MPI_Op, op, MPI_Op_free(&handle));
}
