/* coll_one.c - one to all and all to one: broadcast, gather, scatter; and the barrier.
 *
 * Algorithms and their limits: Thakur, Rabenseifner and Gropp, "Optimization of collective communication
 * operations in MPICH" (2005). */
#include <stdlib.h>
#include <string.h>
#include "coll.h"

/* --- barrier: in step k each rank tells the one 2^k further --- */

CALL(Barrier, (MPI_Comm comm))
{
    struct coll o;
    int code = coll_begin(&o, CALL_Barrier, comm);
    if (code)
        return code;
    int size = coll_size(&o), rank = coll_rank(&o);
    for (int step = 1; step < size; step *= 2) {
        coll_send_bytes(&o, "", 0, (rank + step) % size);
        coll_receive_bytes(&o, NULL, 0, (rank - step + size) % size);
    }
    return MPI_SUCCESS;
}

/* --- broadcast --- */

/* Short ones: a binomial tree. Long ones on many ranks: the parts are scattered, and then gathered by all. */
enum { LONG_BCAST = 12288, FEW_RANKS = 8 };

static int bcast_tree(const struct coll *o, void *buf, int count, MPI_Datatype t, int root)
{
    int size = coll_size(o), rel = (coll_rank(o) - root + size) % size, mask = 1, code = MPI_SUCCESS;
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
    int size = coll_size(o), rel = (coll_rank(o) - root + size) % size, mask = 1;
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
    int size = coll_size(o), rank = coll_rank(o), rel = (rank - root + size) % size;
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
    char *together = type_together(buf, count, t, &bytes);
    if (bytes < LONG_BCAST || coll_size(o) < FEW_RANKS)
        return bcast_tree(o, buf, count, t, root);
    char *data = together ? together : get_memory(bytes);
    if (!together && coll_rank(o) == root)
        type_pack(buf, count, t, data);
    bcast_scatter(o, data, bytes, root);
    bcast_ring(o, data, bytes, root);
    if (!together) {
        if (coll_rank(o) != root)
            type_unpack(data, bytes, buf, count, t);
        free(data);
    }
    return MPI_SUCCESS;
}

CALL(Bcast, (void *buf, int count, MPI_Datatype type, int root, MPI_Comm comm))
{
    struct coll o;
    int code = coll_begin(&o, CALL_Bcast, comm);
    if (!code)
        code = coll_check_root(&o, root);
    if (!code)
        code = coll_check(&o, count, type);
    return code ? code : coll_bcast(&o, buf, count, type, root);
}

/* --- gather and scatter: a binomial tree, in which a rank has the packed parts of those below it --- */

/* How many ranks rel's part of the tree has. */
static int ranks_below(int rel, int size)
{
    int mask = 1;
    while (mask < size && !(rel & mask))
        mask *= 2;
    return rel + mask < size ? mask : size - rel;
}

static int gather(const struct coll *o, const void *buf, int count, MPI_Datatype t, void *into, int room,
                  MPI_Datatype as, int root)
{
    int size = coll_size(o), rank = coll_rank(o), rel = (rank - root + size) % size;
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
            int code = coll_receive_bytes(o, parts + each * (size_t)mask,
                                          each * (size_t)ranks_below(rel + mask, size), (rel + mask + root) % size);
            if (code)
                return free(parts), code;
        }
    }
    if (rank == root && !in_place)
        type_copy(buf, count, t, element(into, (MPI_Aint)root * room, as), room, as);
    for (int i = 1; rank == root && i < size; i++)
        type_unpack(parts + each * (size_t)i, each, element(into, (MPI_Aint)((i + root) % size) * room, as), room,
                    as);
    free(parts);
    return MPI_SUCCESS;
}

CALL(Gather, (const void *buf, int count, MPI_Datatype type, void *into, int room, MPI_Datatype as, int root,
              MPI_Comm comm))
{
    struct coll o;
    int code = coll_begin(&o, CALL_Gather, comm);
    if (!code)
        code = coll_check_root(&o, root);
    if (!code && coll_rank(&o) == root)
        code = coll_check(&o, room, as);
    if (!code && buf != MPI_IN_PLACE)
        code = coll_check(&o, count, type);
    return code ? code : gather(&o, buf, count, type, into, room, as, root);
}

static int scatter(const struct coll *o, const void *buf, int count, MPI_Datatype t, void *into, int room,
                   MPI_Datatype as, int root)
{
    int size = coll_size(o), rank = coll_rank(o), rel = (rank - root + size) % size, code = MPI_SUCCESS;
    size_t each = rank == root ? (size_t)count * size_of(t) : (size_t)room * size_of(as);
    char *parts = get_memory(each * (size_t)ranks_below(rel, size));
    for (int i = 1; rank == root && i < size; i++)
        type_pack(element(buf, (MPI_Aint)((i + root) % size) * count, t), count, t, parts + each * (size_t)i);
    int mask = 1;
    while (mask < size && !(rel & mask))
        mask *= 2;
    if (mask < size)
        code = coll_receive_bytes(o, parts, each * (size_t)ranks_below(rel, size), (rel - mask + root) % size);
    for (mask /= 2; mask > 0 && !code; mask /= 2)
        if (rel + mask < size)
            coll_send_bytes(o, parts + each * (size_t)mask, each * (size_t)ranks_below(rel + mask, size),
                            (rel + mask + root) % size);
    if (rank != root && !code)
        type_unpack(parts, each, into, room, as);
    else if (rank == root && into != MPI_IN_PLACE)
        type_copy(element(buf, (MPI_Aint)root * count, t), count, t, into, room, as);
    free(parts);
    return code;
}

CALL(Scatter, (const void *buf, int count, MPI_Datatype type, void *into, int room, MPI_Datatype as, int root,
               MPI_Comm comm))
{
    struct coll o;
    int code = coll_begin(&o, CALL_Scatter, comm);
    if (!code)
        code = coll_check_root(&o, root);
    if (!code && coll_rank(&o) == root)
        code = coll_check(&o, count, type);
    if (!code && into != MPI_IN_PLACE)
        code = coll_check(&o, room, as);
    return code ? code : scatter(&o, buf, count, type, into, room, as, root);
}

/* --- parts of different lengths: straight from and to the root --- */

CALL(Gatherv, (const void *buf, int count, MPI_Datatype type, void *into, const int rooms[], const int places[],
               MPI_Datatype as, int root, MPI_Comm comm))
{
    struct coll o;
    int code = coll_begin(&o, CALL_Gatherv, comm);
    if (!code)
        code = coll_check_root(&o, root);
    if (code)
        return code;
    int size = coll_size(&o), rank = coll_rank(&o);
    if (rank != root) {
        code = coll_check(&o, count, type);
        if (!code && any_bytes(count, type))
            coll_send(&o, buf, count, type, root);
        return code;
    }
    code = coll_check(&o, 0, as);
    struct request **r = get_memory((size_t)size * sizeof *r);
    for (int i = 0; i < size && !code; i++) {
        void *at = element(into, places[i], as);
        r[i] = NULL;
        if (i != root && any_bytes(rooms[i], as))
            r[i] = coll_start(&o, false, at, rooms[i], as, i);
        else if (i == root && buf != MPI_IN_PLACE)
            type_copy(buf, count, type, at, rooms[i], as);
    }
    if (!code)
        code = coll_wait(&o, size, r);
    free(r);
    return code;
}

int coll_scatterv(const struct coll *o, const void *buf, const int counts[], const int at[], MPI_Datatype t,
                  void *into, int room, MPI_Datatype as, int root)
{
    int size = coll_size(o), rank = coll_rank(o);
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

CALL(Scatterv, (const void *buf, const int counts[], const int at[], MPI_Datatype type, void *into, int room,
                MPI_Datatype as, int root, MPI_Comm comm))
{
    struct coll o;
    int code = coll_begin(&o, CALL_Scatterv, comm);
    if (!code)
        code = coll_check_root(&o, root);
    if (!code && coll_rank(&o) == root)
        code = coll_check(&o, 0, type);
    if (!code && into != MPI_IN_PLACE)
        code = coll_check(&o, room, as);
    return code ? code : coll_scatterv(&o, buf, counts, at, type, into, room, as, root);
}
