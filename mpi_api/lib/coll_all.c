/* coll_all.c - all to all: allgather, alltoall, and their forms with lengths.
 *
 * Algorithms and their limits: Thakur, Rabenseifner and Gropp (2005), as in coll_one.c. */
#include <stdlib.h>
#include <string.h>
#include "coll.h"

/* --- allgather --- */

/* Short ones: Bruck's, log2 of the ranks steps. Long ones: a ring. */
enum { SHORT_GATHER = 81920, MEDIUM_GATHER = 524288 };

static bool is_power_of_two(int n)
{
    return !(n & (n - 1));
}

/* In step k a rank has the parts of 2^k ranks from itself on, and gets as many that follow. */
static int bruck(const struct coll *o, char *parts, size_t each)
{
    int size = o->size, rank = o->rank, code = MPI_SUCCESS;
    for (int have = 1; have < size && !code; have *= 2) {
        int more = have < size - have ? have : size - have;
        code = coll_exchange(o, parts, (int)(each * (size_t)more), MPI_BYTE, (rank - have + size) % size,
                             parts + each * (size_t)have, (int)(each * (size_t)more), MPI_BYTE,
                             (rank + have) % size);
    }
    return code;
}

int coll_allgather_bytes(const struct coll *o, const void *own, size_t bytes, void *all)
{
    size_t before = bytes * (size_t)o->rank, behind = bytes * (size_t)(o->size - o->rank);
    char *parts = get_memory(before + behind);
    memcpy(parts, own, bytes);
    int code = bruck(o, parts, bytes);
    if (!code) {
        memcpy((char *)all + before, parts, behind);
        memcpy(all, parts + behind, before);
    }
    free(parts);
    return code;
}

static int allgather_short(const struct coll *o, void *into, int room, MPI_Datatype as)
{
    int before = o->rank * room, behind = (o->size - o->rank) * room;
    size_t each = size_of(as);
    void *own = element(into, before, as);
    char *parts = get_memory(each * (size_t)(before + behind));
    type_pack(own, room, as, parts);
    int code = bruck(o, parts, each * (size_t)room);
    if (!code) {
        type_unpack(parts, each * (size_t)behind, own, behind, as);
        type_unpack(parts + each * (size_t)behind, each * (size_t)before, into, before, as);
    }
    free(parts);
    return code;
}

/* In step k a rank passes on the part that it got in the step before. */
static int ring(const struct coll *o, void *into, const int rooms[], const int places[], MPI_Datatype as)
{
    int size = o->size, rank = o->rank, code = MPI_SUCCESS;
    for (int k = 0; k < size - 1 && !code; k++) {
        int out = (rank - k + size) % size, in = (rank - k - 1 + size) % size;
        code = coll_exchange(o, element(into, places[out], as), rooms[out], as, (rank + 1) % size,
                             element(into, places[in], as), rooms[in], as, (rank - 1 + size) % size);
    }
    return code;
}

static int ring_of_equals(const struct coll *o, void *into, int room, MPI_Datatype as)
{
    int size = o->size, rank = o->rank, code = MPI_SUCCESS;
    for (int k = 0; k < size - 1 && !code; k++) {
        int out = (rank - k + size) % size, in = (rank - k - 1 + size) % size;
        code = coll_exchange(o, element(into, (MPI_Aint)out * room, as), room, as, (rank + 1) % size,
                             element(into, (MPI_Aint)in * room, as), room, as, (rank - 1 + size) % size);
    }
    return code;
}

static int check_allgather(struct args *a)
{
    int code = coll_check(&a->o, a->rooms ? 0 : a->room, a->as);
    if (!code && a->buf != MPI_IN_PLACE)
        code = coll_check(&a->o, a->count, a->type);
    return code ? code : coll_check_part(a);
}
#define check_allgatherv check_allgather

static int allgather(struct args *a)
{
    const struct coll *o = &a->o;
    if (o->c->remote)
        return inter_allgather(a);
    if (mpi_of_1995)
        return old_allgather(a);
    if (a->buf != MPI_IN_PLACE)
        type_copy(a->buf, a->count, a->type, element(a->into, (MPI_Aint)o->rank * a->room, a->as), a->room,
                  a->as);
    size_t all = (size_t)a->room * size_of(a->as) * (size_t)o->size;
    bool brief = all < SHORT_GATHER || (all < MEDIUM_GATHER && is_power_of_two(o->size));
    return brief ? allgather_short(o, a->into, a->room, a->as) : ring_of_equals(o, a->into, a->room, a->as);
}

static int allgatherv(struct args *a)
{
    const struct coll *o = &a->o;
    if (o->c->remote)
        return inter_allgather(a);
    if (mpi_of_1995)
        return old_allgather(a);
    if (a->buf != MPI_IN_PLACE)
        type_copy(a->buf, a->count, a->type, element(a->into, a->places[o->rank], a->as), a->rooms[o->rank],
                  a->as);
    return ring(o, a->into, a->rooms, a->places, a->as);
}

COLLECTIVE(Allgather, Iallgather, allgather,
           (const void *buf, int count, MPI_Datatype type, void *into, int room, MPI_Datatype as), .buf = buf,
           .count = count, .type = type, .into = into, .room = room, .as = as)
COLLECTIVE(Allgatherv, Iallgatherv, allgatherv,
           (const void *buf, int count, MPI_Datatype type, void *into, const int rooms[], const int places[],
            MPI_Datatype as),
           .buf = buf, .count = count, .type = type, .into = into, .rooms = rooms, .places = places, .as = as)

/* --- alltoall --- */

/* Short ones: Bruck's; of middle length: all at once; long ones: one partner after the other. */
enum { SHORT_ALLTOALL = 256, LONG_ALLTOALL = 32768, FEW_RANKS = 8 };

/* Brief ones without a call. */
static void copy_part(char *to, const char *from, size_t bytes)
{
    enum { WORD = 4, BRIEF = 32 };
    if (bytes > BRIEF || bytes % WORD) {
        memcpy(to, from, bytes);
        return;
    }
    for (size_t i = 0; i < bytes; i += WORD)
        memcpy(to + i, from + i, WORD);
}

/* The parts whose numbers have the bit, in runs of so many, are gathered, or put back: how many bytes. */
static size_t move_marked(char *parts, char *gathered, size_t each, int size, int bit, bool back)
{
    size_t moved = 0;
    for (int first = bit; first < size; first += 2 * bit) {
        char *run = parts + each * (size_t)first;
        size_t bytes = each * (size_t)(bit < size - first ? bit : size - first);
        copy_part(back ? run : gathered + moved, back ? gathered + moved : run, bytes);
        moved += bytes;
    }
    return moved;
}

/* Part i is for the rank i further. In step k all parts whose number has bit k go 2^k ranks on. */
static int alltoall_bruck(const struct coll *o, char *parts, size_t each)
{
    int size = o->size, rank = o->rank, code = MPI_SUCCESS;
    char *out = get_memory(each * (size_t)size), *in = get_memory(each * (size_t)size);
    for (int bit = 1; bit < size && !code; bit *= 2) {
        int bytes = (int)move_marked(parts, out, each, size, bit, false);
        code = coll_exchange(o, out, bytes, MPI_BYTE, (rank + bit) % size, in, bytes, MPI_BYTE,
                             (rank - bit + size) % size);
        move_marked(parts, in, each, size, bit, true);
    }
    free(out);
    free(in);
    return code;
}

/* Part i is from the rank i before. */
static void unpack_parts(const struct coll *o, const char *parts, size_t each, void *into, int room,
                         MPI_Datatype as)
{
    size_t all;
    char *together = type_together(into, room * o->size, as, &all);
    for (int i = 0, from = o->rank; i < o->size; i++, from = from ? from - 1 : o->size - 1) {
        if (together)
            copy_part(together + each * (size_t)from, parts + each * (size_t)i, each);
        else
            type_unpack(parts + each * (size_t)i, each, element(into, (MPI_Aint)from * room, as), room, as);
    }
}

static int alltoall_short(const struct coll *o, const void *buf, int count, MPI_Datatype t, void *into,
                          int room, MPI_Datatype as)
{
    int size = o->size, rank = o->rank, behind = size - rank;
    size_t each = (size_t)room * size_of(as);
    char *parts = get_memory(each * (size_t)size);
    type_pack(element(buf, (MPI_Aint)rank * count, t), behind * count, t, parts);
    type_pack(buf, rank * count, t, parts + each * (size_t)behind);
    int code = alltoall_bruck(o, parts, each);
    if (!code)
        unpack_parts(o, parts, each, into, room, as);
    free(parts);
    return code;
}

void *coll_part_out(const struct args *p, int i, int *count, MPI_Datatype *t)
{
    *t = p->types ? p->types[i] : p->type;
    *count = p->counts ? p->counts[i] : p->count;
    if (p->types)
        return (char *)(uintptr_t)p->buf + p->at[i];
    return element(p->buf, p->counts ? p->at[i] : (MPI_Aint)i * p->count, *t);
}

void *coll_part_in(const struct args *p, int i, int *room, MPI_Datatype *t)
{
    *t = p->ases ? p->ases[i] : p->as;
    *room = p->rooms ? p->rooms[i] : p->room;
    if (p->ases)
        return (char *)p->into + p->places[i];
    return element(p->into, p->rooms ? p->places[i] : (MPI_Aint)i * p->room, *t);
}

int coll_at_once(struct args *p)
{
    const struct coll *o = &p->o;
    if (mpi_of_1995 && !o->c->remote)
        return old_alltoall(p);
    int size = o->size, rank = o->rank, n = 0, count, room;
    bool own_part = !o->c->remote;
    MPI_Datatype t, as;
    struct request **r = get_memory(2 * (size_t)size * sizeof *r);
    for (int k = own_part; k < size; k++) {
        int from = (rank % size - k + size) % size;
        void *at = coll_part_in(p, from, &room, &as);
        if (any_bytes(room, as))
            r[n++] = coll_start(o, false, at, room, as, from);
    }
    for (int k = own_part; k < size; k++) {
        int to = (rank + k) % size;
        void *at = coll_part_out(p, to, &count, &t);
        if (any_bytes(count, t))
            r[n++] = coll_start(o, true, at, count, t, to);
    }
    if (own_part) {
        const void *own = coll_part_out(p, rank, &count, &t);
        void *at = coll_part_in(p, rank, &room, &as);
        type_copy(own, count, t, at, room, as);
    }
    int code = coll_wait(o, n, r);
    free(r);
    return code;
}

static int one_by_one(const struct args *p)
{
    const struct coll *o = &p->o;
    int size = o->size, rank = o->rank, code = MPI_SUCCESS, count, room;
    MPI_Datatype t, as;
    const void *own = coll_part_out(p, rank, &count, &t);
    void *at = coll_part_in(p, rank, &room, &as);
    type_copy(own, count, t, at, room, as);
    for (int k = 1; k < size && !code; k++) {
        int to = is_power_of_two(size) ? rank ^ k : (rank + k) % size;
        int from = is_power_of_two(size) ? to : (rank - k + size) % size;
        const void *out = coll_part_out(p, to, &count, &t);
        void *in = coll_part_in(p, from, &room, &as);
        code = coll_exchange(o, out, count, t, to, in, room, as, from);
    }
    return code;
}

/* In place: what is sent lies where what comes is to lie, so it is copied out first. */
static int in_place(const struct args *p)
{
    int size = p->o.size, room;
    size_t bytes = 0;
    MPI_Datatype as;
    int *counts = get_memory(2 * (size_t)size * sizeof *counts), *at = counts + size;
    for (int i = 0; i < size; i++) {
        coll_part_in(p, i, &room, &as);
        counts[i] = (int)((size_t)room * size_of(as)), at[i] = (int)bytes;
        bytes += (size_t)counts[i];
    }
    char *copy = get_memory(bytes);
    for (int i = 0; i < size; i++) {
        void *from = coll_part_in(p, i, &room, &as);
        type_pack(from, room, as, copy + at[i]);
    }
    struct args q = *p;
    q.buf = copy, q.counts = counts, q.at = at, q.type = MPI_BYTE, q.types = NULL;
    int code = coll_at_once(&q);
    free(copy);
    free(counts);
    return code;
}

static int check_alltoall(struct args *a)
{
    int code = coll_check(&a->o, a->rooms ? 0 : a->room, a->as);
    if (!code && a->buf != MPI_IN_PLACE)
        code = coll_check(&a->o, a->counts ? 0 : a->count, a->type);
    return code ? code : coll_check_apart(a);
}
#define check_alltoallv check_alltoall

static int check_alltoallw(struct args *a)
{
    int code = MPI_SUCCESS;
    for (int i = 0; i < a->o.size && !code; i++) {
        code = coll_check(&a->o, a->rooms[i], a->ases[i]);
        if (!code && a->buf != MPI_IN_PLACE)
            code = coll_check(&a->o, a->counts[i], a->types[i]);
    }
    return code ? code : coll_check_apart(a);
}

static int alltoall(struct args *a)
{
    const struct coll *o = &a->o;
    size_t each = (size_t)a->room * size_of(a->as);
    if (a->buf == MPI_IN_PLACE)
        return in_place(a);
    if (mpi_of_1995)
        return coll_at_once(a);
    if (each <= SHORT_ALLTOALL && o->size >= FEW_RANKS && !o->c->remote)
        return alltoall_short(o, a->buf, a->count, a->type, a->into, a->room, a->as);
    return each <= LONG_ALLTOALL || o->c->remote ? coll_at_once(a) : one_by_one(a);
}

static int alltoallv(struct args *a)
{
    return a->buf == MPI_IN_PLACE ? in_place(a) : coll_at_once(a);
}
#define alltoallw alltoallv

COLLECTIVE(Alltoall, Ialltoall, alltoall,
           (const void *buf, int count, MPI_Datatype type, void *into, int room, MPI_Datatype as), .buf = buf,
           .count = count, .type = type, .into = into, .room = room, .as = as)
COLLECTIVE(Alltoallv, Ialltoallv, alltoallv,
           (const void *buf, const int counts[], const int at[], MPI_Datatype type, void *into,
            const int rooms[], const int places[], MPI_Datatype as),
           .buf = buf, .counts = counts, .at = at, .type = type, .into = into, .rooms = rooms,
           .places = places, .as = as)
COLLECTIVE(Alltoallw, Ialltoallw, alltoallw,
           (const void *buf, const int counts[], const int at[], const MPI_Datatype types[], void *into,
            const int rooms[], const int places[], const MPI_Datatype as[]),
           .buf = buf, .counts = counts, .at = at, .types = types, .into = into, .rooms = rooms,
           .places = places, .ases = as)
