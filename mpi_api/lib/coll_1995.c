/* coll_1995.c - collectives as MPICH 1 made them in 1995, where the machine file says mpi_collectives = 1995:
 * whatever the length, trees for broadcast and reduction, and all else straight, one rank after the other.
 *
 * Read: src/coll/intra_fns.c of MPICH 1, of 31 May 1995, and its coll.h (broadcasts in blocks of one rank).
 * A rank sends its own part to itself there; here that is a copy. What there was not yet (MPI_Exscan) is as
 * now. */
#include <stdlib.h>
#include "coll.h"

static int power_within(int size)
{
    int power = 1;
    while (power <= size / 2)
        power *= 2;
    return power;
}

static int exchange_nothing(const struct coll *o, int peer)
{
    return coll_exchange(o, "", 0, MPI_BYTE, peer, NULL, 0, MPI_BYTE, peer);
}

/* Along the edges of a hypercube; each rank beyond it tells one within first, and is told at last. */
int old_barrier(const struct coll *o)
{
    int rank = o->rank, power = power_within(o->size), code = MPI_SUCCESS;
    if (rank >= power)
        return exchange_nothing(o, rank - power);
    if (rank + power < o->size)
        code = coll_receive_bytes(o, NULL, 0, rank + power);
    for (int mask = 1; mask < power && !code; mask *= 2)
        code = exchange_nothing(o, rank ^ mask);
    if (!code && rank + power < o->size)
        coll_send_bytes(o, "", 0, rank + power);
    return code;
}

/* A binomial tree of as many ranks as are a power of two; then each that has one beyond sends to it. */
int old_bcast(const struct coll *o, void *buf, int count, MPI_Datatype t, int root)
{
    int size = o->size, rel = (o->rank - root + size) % size, power = power_within(size), mask = 1;
    int code = MPI_SUCCESS;
    if (!count)
        return code;
    if (rel >= power)
        return coll_receive(o, buf, count, t, (rel - power + root) % size);
    while (mask < power && !(rel & mask))
        mask *= 2;
    if (mask < power)
        code = coll_receive(o, buf, count, t, (rel - mask + root) % size);
    for (mask /= 2; mask > 0 && !code; mask /= 2)
        coll_send(o, buf, count, t, (rel + mask + root) % size);
    if (!code && rel + power < size)
        coll_send(o, buf, count, t, (rel + power + root) % size);
    return code;
}

int old_gather(struct args *a)
{
    const struct coll *o = &a->o;
    int code = MPI_SUCCESS, room;
    MPI_Datatype as;
    if (o->rank != a->root) {
        coll_send(o, a->buf, a->count, a->type, a->root);
        return code;
    }
    for (int i = 0; i < o->size && !code; i++) {
        void *at = coll_part_in(a, i, &room, &as);
        if (i != o->rank)
            code = coll_receive(o, at, room, as, i);
        else if (a->buf != MPI_IN_PLACE && a->buf != at)
            type_copy(a->buf, a->count, a->type, at, room, as);
    }
    return code;
}

int old_scatter(struct args *a)
{
    const struct coll *o = &a->o;
    int count;
    MPI_Datatype t;
    if (o->rank != a->root)
        return coll_receive(o, a->into, a->room, a->as, a->root);
    for (int i = 0; i < o->size; i++) {
        const void *from = coll_part_out(a, i, &count, &t);
        if (i != o->rank)
            coll_send(o, from, count, t, i);
        else if (a->into != MPI_IN_PLACE)
            type_copy(from, count, t, a->into, a->room, a->as);
    }
    return MPI_SUCCESS;
}

/* To each rank in turn. */
int old_allgather(struct args *a)
{
    struct args b = *a;
    int code = MPI_SUCCESS;
    if (a->buf == MPI_IN_PLACE)
        b.buf = coll_part_in(a, a->o.rank, &b.count, &b.type);
    for (b.root = 0; b.root < a->o.size && !code; b.root++)
        code = old_gather(&b);
    return code;
}

/* All receives and sends are begun, for one rank after the other from the first on. */
int old_alltoall(struct args *a)
{
    const struct coll *o = &a->o;
    int n = 0, count, room;
    MPI_Datatype t, as;
    struct request **r = get_memory(2 * (size_t)o->size * sizeof *r);
    for (int i = 0; i < o->size; i++) {
        void *from = coll_part_out(a, i, &count, &t), *at = coll_part_in(a, i, &room, &as);
        if (i == o->rank) {
            type_copy(from, count, t, at, room, as);
        } else {
            r[n++] = coll_start(o, false, at, room, as, i);
            r[n++] = coll_start(o, true, from, count, t, i);
        }
    }
    int code = coll_wait(o, n, r);
    free(r);
    return code;
}

int old_allreduce(const struct coll *o, const void *buf, void *into, int count, MPI_Datatype t, MPI_Op op)
{
    int code = coll_reduce(o, buf, into, count, t, op, 0);
    return code ? code : old_bcast(o, into, count, t, 0);
}

/* From rank to rank. */
int old_scan(const struct coll *o, const void *buf, void *into, int count, MPI_Datatype t, MPI_Op op)
{
    int code = MPI_SUCCESS;
    struct operand own = operand_new(count, t), before = operand_new(count, t);
    type_copy(buf, count, t, own.at, count, t);
    if (o->rank > 0)
        code = coll_receive(o, before.at, count, t, o->rank - 1);
    if (!code && o->rank > 0)
        op_apply(op, before.at, own.at, count, t);
    if (!code && o->rank + 1 < o->size)
        coll_send(o, own.at, count, t, o->rank + 1);
    if (!code)
        type_copy(own.at, count, t, into, count, t);
    operand_free(before);
    operand_free(own);
    return code;
}
