/* told_accesses.c - see told_accesses.h. */
#include "mpi_api/core/told_accesses.h"
#include <string.h>

enum { MOST_PIECES = 1000 };

struct teller {
    const struct nxm_library *l;
    const struct nxm_told *c;
    told_access_fn *f;
    void *ctx;
};

/* --- elements --- */

static const struct basic *basic_of(const struct nxm_library *l, uintptr_t type)
{
    uintptr_t i = type - FIRST_BASIC;
    return i < BASICS && l->basics[i].class ? &l->basics[i] : NULL;
}

static const struct type *derived_of(const struct nxm_library *l, uintptr_t type)
{
    return (const struct type *)told_object(l, type, TYPE);
}

static MPI_Aint extent_of(const struct nxm_library *l, uintptr_t type)
{
    const struct basic *b = basic_of(l, type);
    const struct type *t = b ? NULL : derived_of(l, type);
    return b ? b->bytes : t ? t->ub - t->lb : 0;
}

size_t told_bytes(const struct nxm_library *l, int count, uintptr_t type)
{
    const struct basic *b = basic_of(l, type);
    const struct type *t = b ? NULL : derived_of(l, type);
    size_t one = b ? b->bytes : t ? t->size : 0;
    return count > 0 ? (size_t)count * one : 0;
}

int told_class(const struct nxm_library *l, uintptr_t type)
{
    const struct basic *b = basic_of(l, type);
    const struct type *t = b ? NULL : derived_of(l, type);
    bool alike = t &&
                 (t->combiner == MPI_COMBINER_CONTIGUOUS || t->combiner == MPI_COMBINER_VECTOR ||
                  t->combiner == MPI_COMBINER_DUP) &&
                 t->types == 1;
    if (alike)
        return told_class(l, (uintptr_t)t->type_list[0]);
    return b && b->class != BITS && b->bytes > 1 ? b->class : NO_TYPE;
}

static void tell(const struct teller *t, struct told_access a)
{
    if (a.bytes)
        t->f(t->ctx, &a);
}

/* Elements of a datatype that lie apart. */
static void tell_pieces(const struct teller *t, uintptr_t buf, int count, const struct type *type, bool write)
{
    struct told_access a = {0, 0, write, true};
    int pieces = 0;
    for (int i = 0; i < count && pieces < MOST_PIECES; i++)
        for (int k = 0; k < type->runs && pieces < MOST_PIECES; k++) {
            uintptr_t at = buf + (uintptr_t)(i * (type->ub - type->lb) + type->run[k].at);
            if (a.at + a.bytes != at) {
                tell(t, a);
                pieces++;
                a.at = at, a.bytes = 0;
            }
            a.bytes += type->run[k].bytes;
        }
    tell(t, a);
}

/* `count` elements in a buffer. */
static void tell_elements(const struct teller *t, uintptr_t buf, int count, uintptr_t type, bool write,
                          bool exact)
{
    const struct basic *b = basic_of(t->l, type);
    const struct type *d = b ? NULL : derived_of(t->l, type);
    if (count <= 0 || buf == (uintptr_t)MPI_IN_PLACE)
        return;
    if (b)
        tell(t, (struct told_access){buf, (size_t)count * b->bytes, write, exact});
    else if (d && (d->runs > 1 || d->ub - d->lb != (MPI_Aint)d->size))
        tell_pieces(t, buf, count, d, write);
    else if (d && d->runs)
        tell(t, (struct told_access){buf + (uintptr_t)d->run->at, (size_t)count * d->size, write, exact});
}

void told_request_accesses(const struct nxm_library *l, const struct request *r, told_access_fn *f, void *ctx)
{
    const struct teller t = {l, NULL, f, ctx};
    bool receives = r->what == RECEIVES;
    if (r->peer != MPI_PROC_NULL)
        tell_elements(&t, (uintptr_t)r->buf, r->count, (uintptr_t)r->type, receives, !receives);
}

/* --- calls --- */

/* How much of a buffer: `count` elements; of each rank of the communicator as many; of each as arrays say, at
 * places in elements, or in bytes with types of their own; the sum of an array; of it the own rank's. */
enum amount { NONE, ONE, EACH, LISTED, LISTED_TYPES, SUM, OWN };

static const struct shape {
    const char *stem;
    enum amount reads, writes;
    bool root_reads, root_writes; /* only the root does */
    bool reduces;                 /* both buffers have the same count and type */
} shapes[] = {
    {"Send", ONE, NONE, false, false, false},
    {"Bsend", ONE, NONE, false, false, false},
    {"Ssend", ONE, NONE, false, false, false},
    {"Rsend", ONE, NONE, false, false, false},
    {"Sendrecv", ONE, ONE, false, false, false},
    {"Sendrecv_replace", ONE, NONE, false, false, false},
    {"Gather", ONE, EACH, false, true, false},
    {"Gatherv", ONE, LISTED, false, true, false},
    {"Scatter", EACH, ONE, true, false, false},
    {"Scatterv", LISTED, ONE, true, false, false},
    {"Allgather", ONE, EACH, false, false, false},
    {"Allgatherv", ONE, LISTED, false, false, false},
    {"Alltoall", EACH, EACH, false, false, false},
    {"Alltoallv", LISTED, LISTED, false, false, false},
    {"Alltoallw", LISTED_TYPES, LISTED_TYPES, false, false, false},
    {"Reduce", ONE, ONE, false, true, true},
    {"Allreduce", ONE, ONE, false, false, true},
    {"Scan", ONE, ONE, false, false, true},
    {"Exscan", ONE, ONE, false, false, true},
    {"Reduce_scatter_block", EACH, ONE, false, false, true},
    {"Reduce_scatter", SUM, OWN, false, false, true},
};

/* The names of a buffer's arguments. */
struct names {
    const char *buf, *count, *type, *counts, *at, *types;
};
static const struct names from = {"buf", "count", "type", "counts", "at", "types"};
static const struct names into = {"into", "room", "as", "rooms", "places", "as"};
static const struct names result = {"into", "count", "type", "counts", NULL, NULL};

static uintptr_t argument(const struct teller *t, const char *name)
{
    uintptr_t value = 0;
    if (name)
        told_argument(t->c, name, &value);
    return value;
}

static void tell_listed(const struct teller *t, const struct names *k, bool own_types, int size, bool write)
{
    uintptr_t buf = argument(t, k->buf), type = argument(t, k->type);
    const int *counts = (const int *)argument(t, k->counts), *at = (const int *)argument(t, k->at);
    const MPI_Datatype *types = (const MPI_Datatype *)argument(t, k->types);
    if (!counts || !at || buf == (uintptr_t)MPI_IN_PLACE)
        return;
    for (int i = 0; i < size; i++) {
        uintptr_t as = own_types ? (uintptr_t)types[i] : type;
        MPI_Aint away = own_types ? at[i] : at[i] * extent_of(t->l, type);
        tell_elements(t, buf + (uintptr_t)away, counts[i], as, write, true);
    }
}

static int count_of(const struct teller *t, const struct names *k, enum amount amount,
                    const struct group *group)
{
    int count = (int)argument(t, k->count), sum = 0;
    const int *counts = (const int *)argument(t, k->counts);
    if (amount == ONE || amount == EACH)
        return amount == EACH ? count * group->size : count;
    if (!counts)
        return 0;
    for (int i = 0; i < group->size; i++)
        sum += counts[i];
    return amount == SUM ? sum : counts[group->rank];
}

static void tell_part(const struct teller *t, const struct names *k, enum amount amount,
                      const struct group *group, bool write)
{
    if (amount == LISTED || amount == LISTED_TYPES)
        tell_listed(t, k, amount == LISTED_TYPES, group->size, write);
    else if (amount != NONE)
        tell_elements(t, argument(t, k->buf), count_of(t, k, amount, group), argument(t, k->type), write,
                      true);
}

/* A receive, or the part of Sendrecv that is one. */
static void tell_receive(const struct teller *t, const struct names *k)
{
    if (told_int(t->c, "source", MPI_PROC_NULL) != MPI_PROC_NULL)
        tell_elements(t, argument(t, k->buf), (int)argument(t, k->count), argument(t, k->type), true, false);
}

static void tell_shape(const struct teller *t, const struct shape *s, const struct group *group)
{
    int root = told_int(t->c, "root", group->rank);
    if (told_int(t->c, "dest", 0) != MPI_PROC_NULL && (root == group->rank || !s->root_reads))
        tell_part(t, &from, s->reads, group, false);
    if (strcmp(s->stem, "Sendrecv") == 0)
        tell_receive(t, &into);
    else if (strcmp(s->stem, "Sendrecv_replace") == 0)
        tell_receive(t, &from);
    else if (root == group->rank || !s->root_writes)
        tell_part(t, s->reduces ? &result : &into, s->writes, group, true);
}

void told_accesses(const struct nxm_library *l, const struct nxm_told *c, told_access_fn *f, void *ctx)
{
    const struct teller t = {l, c, f, ctx};
    const struct comm *comm = told_comm(l, c);
    char stem[64];
    told_stem(c, stem);
    if (!comm || comm->remote) /* of two groups: who reads and writes what is another matter */
        return;
    if (strcmp(stem, "Recv") == 0)
        tell_receive(&t, &from);
    if (strcmp(stem, "Bcast") == 0)
        tell_part(&t, &from, ONE, comm->local, told_int(c, "root", 0) != comm->local->rank);
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
        if (strcmp(stem, shapes[i].stem) == 0)
            tell_shape(&t, &shapes[i], comm->local);
}
