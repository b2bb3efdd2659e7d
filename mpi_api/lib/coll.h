/* coll.h - collectives. Each is written once, and serves as a blocking call, as one with a request, and as a
 * persistent one (coll_call). Its messages go in the other half of the communicator's context; their tag is
 * the number of the collective on the communicator, so that several may be under way.
 *
 * A communicator of two groups: ranks name those of the other group, and struct coll of the local one is had
 * by coll_inside. */
#ifndef MPI_COLL_H
#define MPI_COLL_H
#include "lib.h"

struct coll {
    struct comm *c;
    int call, tag;
    const struct group *group; /* whom ranks name */
    int size, rank;            /* of the group; the own rank, in the local one */
};

/* A collective of the communicator: the next in order. */
struct coll coll_of(struct comm *c, int call);
/* That of two groups as one of the local group alone. */
struct coll coll_inside(const struct coll *o);

/* What a collective is given: as named in mpi_calls.h. */
struct args {
    struct coll o;
    const void *buf;
    void *into;
    int count, room, root;
    const int *counts, *at, *rooms, *places;
    MPI_Datatype type, as;
    const MPI_Datatype *types, *ases;
    const MPI_Aint *out_addresses, *in_addresses; /* between neighbours: bytes */
    bool same;                                    /* each gets the same part */
    MPI_Op op;
};
/* The program may free an operation and datatypes while a collective that it has begun uses them. */
void args_keep(const struct args *a);
void args_leave(const struct args *a);
typedef int coll_run(struct args *a);
/* Checks and runs a collective; or begins one, whose request is `request`. */
int coll_call(struct args *a, int call, MPI_Comm comm, coll_run *check, coll_run *run, MPI_Request *request);
/* The request of a persistent one, which MPI_Start begins. */
int coll_prepare(struct args *a, int call, MPI_Comm comm, coll_run *check, coll_run *run,
                 MPI_Request *request);
void coll_restart(struct request *r);
void coll_forget(const struct prepared *p); /* it is about to be freed */
/* A list that the collective was given is freed with its request. */
void coll_keep_list(MPI_Request request, void *list);

/* The three forms of a call. The parameters, in parentheses; the values of struct args. */
#define COLLECTIVE(name, iname, function, parameters, ...)                                                   \
    CALL(name, (COLL_LIST parameters MPI_Comm comm))                                                         \
    {                                                                                                        \
        struct args a = {__VA_ARGS__};                                                                       \
        return coll_call(&a, CALL_##name, comm, check_##function, function, NULL);                           \
    }                                                                                                        \
    CALL(iname, (COLL_LIST parameters MPI_Comm comm, MPI_Request * request))                                 \
    {                                                                                                        \
        struct args a = {__VA_ARGS__};                                                                       \
        return coll_call(&a, CALL_##iname, comm, check_##function, function, request);                       \
    }                                                                                                        \
    CALL(name##_init, (COLL_LIST parameters MPI_Comm comm, MPI_Info info, MPI_Request * request))            \
    {                                                                                                        \
        struct args a = {__VA_ARGS__};                                                                       \
        (void)info;                                                                                          \
        return coll_prepare(&a, CALL_##name##_init, comm, check_##function, function, request);              \
    }
#define COLL_LIST(...) __VA_ARGS__ __VA_OPT__(, )

/* Within one group: a context that no other communicator of its processes has. */
int comm_agree_context(const struct coll *o);

int coll_check_root(const struct coll *o, int root);
/* A count and a type of an argument. */
int coll_check(const struct coll *o, int count, MPI_Datatype t);

/* The memory sent from may not be the memory received in, but by MPI_IN_PLACE: else an error. */
int coll_fail_same(const struct args *a);
static inline int coll_check_apart(const struct args *a)
{
    return SELDOM(a->buf == a->into) ? coll_fail_same(a) : MPI_SUCCESS;
}
/* Fails in that way, for a gather or scatter. Programs of MPI-1 often have the rank's own part in its place
 * already: they go on, since that has one meaning only, unless the program has errors returned. */
int coll_fail_part(const struct args *a);
static inline int coll_check_part(const struct args *a)
{
    return SELDOM(a->buf == a->into) ? coll_fail_part(a) : MPI_SUCCESS;
}

void coll_send(const struct coll *o, const void *buf, int count, MPI_Datatype t, int to);
int coll_receive(const struct coll *o, void *buf, int count, MPI_Datatype t, int from);
/* Both at once. */
int coll_exchange(const struct coll *o, const void *buf, int count, MPI_Datatype t, int to, void *into,
                  int room, MPI_Datatype as, int from);
/* Those of many, which are waited for together; some may be NULL. */
struct request *coll_start(const struct coll *o, bool sends, void *buf, int count, MPI_Datatype t, int peer);
int coll_wait(const struct coll *o, int count, struct request *r[]);
/* Bytes. */
static inline void coll_send_bytes(const struct coll *o, const void *buf, size_t bytes, int to)
{
    coll_send(o, buf, (int)bytes, MPI_BYTE, to);
}
static inline int coll_receive_bytes(const struct coll *o, void *buf, size_t bytes, int from)
{
    return coll_receive(o, buf, (int)bytes, MPI_BYTE, from);
}

/* Algorithms that several calls use, within one group; checked. */
int coll_barrier(const struct coll *o);
int coll_bcast(const struct coll *o, void *buf, int count, MPI_Datatype t, int root);
int coll_reduce(const struct coll *o, const void *buf, void *into, int count, MPI_Datatype t, MPI_Op op,
                int root);
int coll_allreduce(const struct coll *o, const void *buf, void *into, int count, MPI_Datatype t, MPI_Op op);
/* Each rank has a number for each; what all have for this one. */
int coll_sum_for_each(const struct coll *o, const int counts[], int *own);
int coll_allgather_bytes(const struct coll *o, const void *own, size_t bytes, void *all);
int coll_scatterv(const struct coll *o, const void *buf, const int counts[], const int at[], MPI_Datatype t,
                  void *into, int room, MPI_Datatype as, int root);
/* The part for a rank, and the part from a rank: lists of counts, or the same count for all. */
void *coll_part_out(const struct args *a, int i, int *count, MPI_Datatype *t);
void *coll_part_in(const struct args *a, int i, int *room, MPI_Datatype *t);
/* All parts at once: each rank's own, unless the communicator has two groups. */
int coll_at_once(struct args *a);

/* Collectives of two groups. */
coll_run inter_barrier, inter_bcast, inter_gather, inter_scatter, inter_allgather, inter_reduce,
    inter_allreduce, inter_reduce_scatter;

/* Within one group, as in 1995. */
int old_barrier(const struct coll *o);
int old_bcast(const struct coll *o, void *buf, int count, MPI_Datatype t, int root);
int old_allreduce(const struct coll *o, const void *buf, void *into, int count, MPI_Datatype t, MPI_Op op);
int old_scan(const struct coll *o, const void *buf, void *into, int count, MPI_Datatype t, MPI_Op op);
coll_run old_gather, old_scatter, old_allgather, old_alltoall;

static inline bool any_bytes(int count, MPI_Datatype t)
{
    return count > 0 && size_of(t) > 0;
}
/* Where the i-th element of a buffer lies. */
static inline void *element(const void *buf, MPI_Aint i, MPI_Datatype t)
{
    return (char *)(uintptr_t)buf + i * extent_of(t);
}

/* Memory for elements of any type, which lie in it as in the program's. */
struct operand {
    char *memory, *at;
};
struct operand operand_new(int count, MPI_Datatype type);
void operand_free(struct operand x);
#endif
