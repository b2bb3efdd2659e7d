/* coll_inter.c - collectives of communicators of two groups: within each group by the algorithms for one, and
 * between them straight, mostly by the two first ranks. */
#include <stdlib.h>
#include "coll.h"

/* The first ranks of the two groups exchange. */
static int leaders(const struct args *a, const void *own, int count, void *theirs, int room)
{
    if (a->o.rank)
        return MPI_SUCCESS;
    return coll_exchange(&a->o, own, count, a->type, 0, theirs, room, a->type, 0);
}

int inter_barrier(struct args *a)
{
    const struct coll in = coll_inside(&a->o);
    struct args b = *a;
    b.type = MPI_BYTE;
    int code = coll_barrier(&in);
    if (!code)
        code = leaders(&b, "", 0, NULL, 0);
    return code ? code : coll_barrier(&in);
}

/* From the root to the other group's first rank, and there to all. */
int inter_bcast(struct args *a)
{
    const struct coll in = coll_inside(&a->o);
    int code = MPI_SUCCESS;
    if (a->root == MPI_ROOT)
        coll_send(&a->o, a->into, a->count, a->type, 0);
    if (a->root < 0)
        return MPI_SUCCESS;
    if (!a->o.rank)
        code = coll_receive(&a->o, a->into, a->count, a->type, a->root);
    return code ? code : coll_bcast(&in, a->into, a->count, a->type, 0);
}

int inter_gather(struct args *a)
{
    const struct coll *o = &a->o;
    int code = MPI_SUCCESS, room;
    MPI_Datatype as;
    if (a->root >= 0)
        coll_send(o, a->buf, a->count, a->type, a->root);
    for (int i = 0; a->root == MPI_ROOT && i < o->size && !code; i++) {
        void *at = coll_part_in(a, i, &room, &as);
        code = coll_receive(o, at, room, as, i);
    }
    return code;
}

int inter_scatter(struct args *a)
{
    const struct coll *o = &a->o;
    int count;
    MPI_Datatype t;
    for (int i = 0; a->root == MPI_ROOT && i < o->size; i++) {
        const void *from = coll_part_out(a, i, &count, &t);
        coll_send(o, from, count, t, i);
    }
    return a->root >= 0 ? coll_receive(o, a->into, a->room, a->as, a->root) : MPI_SUCCESS;
}

/* Each rank to each of the other group. */
int inter_allgather(struct args *a)
{
    int size = a->o.size, *counts = get_memory(2 * (size_t)size * sizeof *counts), *at = counts + size;
    struct args b = *a;
    for (int i = 0; i < size; i++)
        counts[i] = a->count, at[i] = 0;
    b.counts = counts, b.at = at;
    int code = coll_at_once(&b);
    free(counts);
    return code;
}

int inter_reduce(struct args *a)
{
    const struct coll in = coll_inside(&a->o);
    int code = MPI_SUCCESS;
    if (a->root == MPI_ROOT)
        return coll_receive(&a->o, a->into, a->count, a->type, 0);
    if (a->root < 0)
        return MPI_SUCCESS;
    struct operand sum = operand_new(a->count, a->type);
    code = coll_reduce(&in, a->buf, sum.at, a->count, a->type, a->op, 0);
    if (!code && !a->o.rank)
        coll_send(&a->o, sum.at, a->count, a->type, a->root);
    operand_free(sum);
    return code;
}

/* Each group gets the other's sum. */
int inter_allreduce(struct args *a)
{
    const struct coll in = coll_inside(&a->o);
    struct operand sum = operand_new(a->count, a->type);
    int code = coll_reduce(&in, a->buf, sum.at, a->count, a->type, a->op, 0);
    if (!code)
        code = leaders(a, sum.at, a->count, a->into, a->count);
    operand_free(sum);
    return code ? code : coll_bcast(&in, a->into, a->count, a->type, 0);
}

int inter_reduce_scatter(struct args *a)
{
    const struct coll in = coll_inside(&a->o);
    int total = 0, *at = get_memory((size_t)in.size * sizeof *at);
    for (int i = 0; i < in.size; i++) {
        at[i] = total;
        total += a->counts[i];
    }
    struct operand own = operand_new(total, a->type), theirs = operand_new(total, a->type);
    int code = coll_reduce(&in, a->buf, own.at, total, a->type, a->op, 0);
    if (!code)
        code = leaders(a, own.at, total, theirs.at, total);
    if (!code)
        code = coll_scatterv(&in, theirs.at, a->counts, at, a->type, a->into, a->counts[in.rank], a->type, 0);
    operand_free(own);
    operand_free(theirs);
    free(at);
    return code;
}
