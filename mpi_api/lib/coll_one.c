/* coll_one.c - one to all and all to one: broadcast, gather, scatter; and the barrier.
 *
 * Algorithms and their limits: Thakur, Rabenseifner and Gropp, "Optimization of collective communication
 * operations in MPICH" (2005). */
#include <stdlib.h>
#include <string.h>
#include "coll.h"

/* --- barrier: in step k each rank tells the one 2^k further --- */

int coll_barrier(const struct coll *o)
{
    int code = MPI_SUCCESS;
    if (mpi_of_1995)
        return old_barrier(o);
    for (int step = 1; step < o->size && !code; step *= 2) {
        coll_send_bytes(o, "", 0, (o->rank + step) % o->size);
        code = coll_receive_bytes(o, NULL, 0, (o->rank - step + o->size) % o->size);
    }
    return code;
}

static int check_barrier(struct args *a)
{
    (void)a;
    return MPI_SUCCESS;
}

static int barrier(struct args *a)
{
    return a->o.c->remote ? inter_barrier(a) : coll_barrier(&a->o);
}

COLLECTIVE(Barrier, Ibarrier, barrier, (), .root = 0)

/* --- broadcast --- */

/* Short ones: a binomial tree. Long ones on many ranks: the parts are scattered, and then gathered by all. */
enum { LONG_BCAST = 12288, FEW_RANKS = 8 };

static int bcast_tree(const struct coll *o, void *buf, int count, MPI_Datatype t, int root)
{
    int size = o->size, rel = (o->rank - root + size) % size, mask = 1, code = MPI_SUCCESS;
    while (mask < size && !(rel & mask))
        mask *= 2;
    if (mask < size)
        code = coll_receive(o, buf, count, t, (rel - mask + root) % size);
    for (mask /= 2; mask > 0; mask /= 2)
        if (rel + mask < size)
            coll_send(o, buf, count, t, (rel + mask + root) % size);
    return code;
}

static size_t part_at(size_t bytes, int size, int part)
{
    size_t each = (bytes + (size_t)size - 1) / (size_t)size, at = each * (size_t)part;
    return at < bytes ? at : bytes;
}

/* Parts are numbered from the root's rank on; a rank gets those of its part of the tree. */
static void bcast_scatter(const struct coll *o, char *data, size_t bytes, int root)
{
    int size = o->size, rel = (o->rank - root + size) % size, mask = 1;
    while (mask < size && !(rel & mask))
        mask *= 2;
    if (mask < size) {
        int last = rel + mask < size ? rel + mask : size;
        size_t at = part_at(bytes, size, rel);
        coll_receive_bytes(o, data + at, part_at(bytes, size, last) - at, (rel - mask + root) % size);
    }
    for (mask /= 2; mask > 0; mask /= 2)
        if (rel + mask < size) {
            int first = rel + mask, last = first + mask < size ? first + mask : size;
            size_t at = part_at(bytes, size, first);
            coll_send_bytes(o, data + at, part_at(bytes, size, last) - at, (first + root) % size);
        }
}

/* In step k a rank passes on the part that it got in the step before. */
static void bcast_ring(const struct coll *o, char *data, size_t bytes, int root)
{
    int size = o->size, rank = o->rank, rel = (rank - root + size) % size;
    int left = (rank - 1 + size) % size, right = (rank + 1) % size;
    for (int k = 0; k < size - 1; k++) {
        int out = (rel - k + size) % size, in = (rel - k - 1 + size) % size;
        size_t out_at = part_at(bytes, size, out), in_at = part_at(bytes, size, in);
        coll_exchange(o, data + out_at, (int)(part_at(bytes, size, out + 1) - out_at), MPI_BYTE, right,
                      data + in_at, (int)(part_at(bytes, size, in + 1) - in_at), MPI_BYTE, left);
    }
}

int coll_bcast(const struct coll *o, void *buf, int count, MPI_Datatype t, int root)
{
    size_t bytes;
    if (mpi_of_1995)
        return old_bcast(o, buf, count, t, root);
    char *together = type_together(buf, count, t, &bytes);
    if (bytes < LONG_BCAST || o->size < FEW_RANKS)
        return bcast_tree(o, buf, count, t, root);
    char *data = together ? together : get_memory(bytes);
    if (!together && o->rank == root)
        type_pack(buf, count, t, data);
    bcast_scatter(o, data, bytes, root);
    bcast_ring(o, data, bytes, root);
    if (!together) {
        if (o->rank != root)
            type_unpack(data, bytes, buf, count, t);
        free(data);
    }
    return MPI_SUCCESS;
}

static int check_bcast(struct args *a)
{
    int code = coll_check_root(&a->o, a->root);
    return code ? code : coll_check(&a->o, a->count, a->type);
}

static int bcast(struct args *a)
{
    return a->o.c->remote ? inter_bcast(a) : coll_bcast(&a->o, a->into, a->count, a->type, a->root);
}

COLLECTIVE(Bcast, Ibcast, bcast, (void *buf, int count, MPI_Datatype type, int root), .into = buf,
           .count = count, .type = type, .root = root)

/* --- gather and scatter: a binomial tree, in which a rank has the packed parts of those below it --- */

/* How many ranks rel's part of the tree has. */
static int ranks_below(int rel, int size)
{
    int mask = 1;
    while (mask < size && !(rel & mask))
        mask *= 2;
    return rel + mask < size ? mask : size - rel;
}

static int gather_tree(const struct args *a)
{
    const struct coll *o = &a->o;
    const void *buf = a->buf;
    int count = a->count, room = a->room, root = a->root;
    MPI_Datatype t = a->type, as = a->as;
    int size = o->size, rank = o->rank, rel = (rank - root + size) % size;
    bool in_place = rank == root && buf == MPI_IN_PLACE;
    size_t each = rank == root ? (size_t)room * size_of(as) : (size_t)count * size_of(t);
    char *parts = get_memory(each * (size_t)ranks_below(rel, size));
    if (rank != root)
        type_pack(buf, count, t, parts);
    for (int mask = 1; mask < size; mask *= 2) {
        if (rel & mask) {
            coll_send_bytes(o, parts, each * (size_t)ranks_below(rel, size), (rel - mask + root) % size);
            break;
        }
        if (rel + mask < size) {
            int code =
                coll_receive_bytes(o, parts + each * (size_t)mask,
                                   each * (size_t)ranks_below(rel + mask, size), (rel + mask + root) % size);
            if (code)
                return free(parts), code;
        }
    }
    if (rank == root && !in_place)
        type_copy(buf, count, t, element(a->into, (MPI_Aint)root * room, as), room, as);
    for (int i = 1; rank == root && i < size; i++)
        type_unpack(parts + each * (size_t)i, each,
                    element(a->into, (MPI_Aint)((i + root) % size) * room, as), room, as);
    free(parts);
    return MPI_SUCCESS;
}

static int check_gather(struct args *a)
{
    bool gets = a->root == MPI_ROOT || (a->root == a->o.rank && !a->o.c->remote);
    int code = coll_check_root(&a->o, a->root);
    if (!code && gets)
        code = coll_check(&a->o, a->rooms ? 0 : a->room, a->as);
    if (!code && a->buf != MPI_IN_PLACE && a->root >= 0)
        code = coll_check(&a->o, a->count, a->type);
    return code || !gets ? code : coll_check_part(a);
}

static int gather(struct args *a)
{
    return a->o.c->remote ? inter_gather(a) : mpi_of_1995 ? old_gather(a) : gather_tree(a);
}
#define check_gatherv check_gather

COLLECTIVE(Gather, Igather, gather,
           (const void *buf, int count, MPI_Datatype type, void *into, int room, MPI_Datatype as, int root),
           .buf = buf, .count = count, .type = type, .into = into, .room = room, .as = as, .root = root)

static int scatter_tree(const struct args *a)
{
    const struct coll *o = &a->o;
    void *into = a->into;
    int count = a->count, room = a->room, root = a->root;
    MPI_Datatype t = a->type, as = a->as;
    int size = o->size, rank = o->rank, rel = (rank - root + size) % size, code = MPI_SUCCESS;
    size_t each = rank == root ? (size_t)count * size_of(t) : (size_t)room * size_of(as);
    char *parts = get_memory(each * (size_t)ranks_below(rel, size));
    for (int i = 1; rank == root && i < size; i++)
        type_pack(element(a->buf, (MPI_Aint)((i + root) % size) * count, t), count, t,
                  parts + each * (size_t)i);
    int mask = 1;
    while (mask < size && !(rel & mask))
        mask *= 2;
    if (mask < size)
        code =
            coll_receive_bytes(o, parts, each * (size_t)ranks_below(rel, size), (rel - mask + root) % size);
    for (mask /= 2; mask > 0 && !code; mask /= 2)
        if (rel + mask < size)
            coll_send_bytes(o, parts + each * (size_t)mask, each * (size_t)ranks_below(rel + mask, size),
                            (rel + mask + root) % size);
    if (rank != root && !code)
        type_unpack(parts, each, into, room, as);
    else if (rank == root && into != MPI_IN_PLACE)
        type_copy(element(a->buf, (MPI_Aint)root * count, t), count, t, into, room, as);
    free(parts);
    return code;
}

static int check_scatter(struct args *a)
{
    bool gives = a->root == MPI_ROOT || (a->root == a->o.rank && !a->o.c->remote);
    int code = coll_check_root(&a->o, a->root);
    if (!code && gives)
        code = coll_check(&a->o, a->counts ? 0 : a->count, a->type);
    if (!code && a->into != MPI_IN_PLACE && a->root >= 0)
        code = coll_check(&a->o, a->room, a->as);
    return code || !gives ? code : coll_check_part(a);
}

static int scatter(struct args *a)
{
    return a->o.c->remote ? inter_scatter(a) : mpi_of_1995 ? old_scatter(a) : scatter_tree(a);
}
#define check_scatterv check_scatter

COLLECTIVE(Scatter, Iscatter, scatter,
           (const void *buf, int count, MPI_Datatype type, void *into, int room, MPI_Datatype as, int root),
           .buf = buf, .count = count, .type = type, .into = into, .room = room, .as = as, .root = root)

/* --- parts of different lengths: straight from and to the root --- */

static int gather_parts(const struct args *a)
{
    const struct coll *o = &a->o;
    int code;
    if (o->rank != a->root) {
        if (any_bytes(a->count, a->type))
            coll_send(o, a->buf, a->count, a->type, a->root);
        return MPI_SUCCESS;
    }
    struct request **r = get_memory((size_t)o->size * sizeof *r);
    for (int i = 0; i < o->size; i++) {
        void *at = element(a->into, a->places[i], a->as);
        r[i] = NULL;
        if (i != o->rank && any_bytes(a->rooms[i], a->as))
            r[i] = coll_start(o, false, at, a->rooms[i], a->as, i);
        else if (i == o->rank && a->buf != MPI_IN_PLACE)
            type_copy(a->buf, a->count, a->type, at, a->rooms[i], a->as);
    }
    code = coll_wait(o, o->size, r);
    free(r);
    return code;
}

static int gatherv(struct args *a)
{
    return a->o.c->remote ? inter_gather(a) : mpi_of_1995 ? old_gather(a) : gather_parts(a);
}

COLLECTIVE(Gatherv, Igatherv, gatherv,
           (const void *buf, int count, MPI_Datatype type, void *into, const int rooms[], const int places[],
            MPI_Datatype as, int root),
           .buf = buf, .count = count, .type = type, .into = into, .rooms = rooms, .places = places, .as = as,
           .root = root)

int coll_scatterv(const struct coll *o, const void *buf, const int counts[], const int at[], MPI_Datatype t,
                  void *into, int room, MPI_Datatype as, int root)
{
    int size = o->size, rank = o->rank;
    if (mpi_of_1995)
        return old_scatter(&(struct args){.o = *o,
                                          .buf = buf,
                                          .counts = counts,
                                          .at = at,
                                          .type = t,
                                          .into = into,
                                          .room = room,
                                          .as = as,
                                          .root = root});
    if (rank != root)
        return any_bytes(room, as) ? coll_receive(o, into, room, as, root) : MPI_SUCCESS;
    struct request **r = get_memory((size_t)size * sizeof *r);
    for (int i = 0; i < size; i++) {
        void *from = element(buf, at[i], t);
        r[i] = NULL;
        if (i != root && any_bytes(counts[i], t))
            r[i] = coll_start(o, true, from, counts[i], t, i);
        else if (i == root && into != MPI_IN_PLACE)
            type_copy(from, counts[i], t, into, room, as);
    }
    int code = coll_wait(o, size, r);
    free(r);
    return code;
}

static int scatterv(struct args *a)
{
    if (a->o.c->remote)
        return inter_scatter(a);
    return coll_scatterv(&a->o, a->buf, a->counts, a->at, a->type, a->into, a->room, a->as, a->root);
}

COLLECTIVE(Scatterv, Iscatterv, scatterv,
           (const void *buf, const int counts[], const int at[], MPI_Datatype type, void *into, int room,
            MPI_Datatype as, int root),
           .buf = buf, .counts = counts, .at = at, .type = type, .into = into, .room = room, .as = as,
           .root = root)
