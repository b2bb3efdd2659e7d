/* coll.h - messages of collectives: in the other half of the communicator's context, with the call's number as
 * the tag, between ranks of its local group. */
#ifndef MPI_COLL_H
#define MPI_COLL_H
#include "lib.h"

struct coll {
    struct comm *c;
    int call;
};

static inline int coll_size(const struct coll *o)
{
    return o->c->local->size;
}
static inline int coll_rank(const struct coll *o)
{
    return o->c->local->rank;
}
/* A call of a collective on this communicator: 0, or the error. */
int coll_begin(struct coll *o, int call, MPI_Comm comm);
int coll_check_root(const struct coll *o, int root);
/* A count and a type of an argument. */
int coll_check(const struct coll *o, int count, MPI_Datatype t);

void coll_send(const struct coll *o, const void *buf, int count, MPI_Datatype t, int to);
int coll_receive(const struct coll *o, void *buf, int count, MPI_Datatype t, int from);
/* Both at once. */
int coll_exchange(const struct coll *o, const void *buf, int count, MPI_Datatype t, int to, void *into,
                  int room, MPI_Datatype as, int from);
/* Those of many, which are waited for together. */
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

/* Algorithms that several calls use; checked. */
int coll_bcast(const struct coll *o, void *buf, int count, MPI_Datatype t, int root);
int coll_allreduce(const struct coll *o, const void *buf, void *into, int count, MPI_Datatype t, MPI_Op op);
int coll_reduce(const struct coll *o, const void *buf, void *into, int count, MPI_Datatype t, MPI_Op op,
                int root);
int coll_allgather_bytes(const struct coll *o, const void *own, size_t bytes, void *all);
int coll_scatterv(const struct coll *o, const void *buf, const int counts[], const int at[], MPI_Datatype t,
                  void *into, int room, MPI_Datatype as, int root);

static inline bool any_bytes(int count, MPI_Datatype t)
{
    return count > 0 && size_of(t) > 0;
}
/* Where the i-th element of a buffer lies. */
static inline void *element(const void *buf, MPI_Aint i, MPI_Datatype t)
{
    return (char *)(uintptr_t)buf + i * extent_of(t);
}
#endif
