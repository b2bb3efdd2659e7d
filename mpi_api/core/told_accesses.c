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

static MPI_Aint extent_of(const struct nxm_library *l, uintptr_t type)
{
    const struct basic *b = told_basic(l, type);
    const struct type *t = b ? NULL : told_type(l, type);
    return b ? b->bytes : t ? t->ub - t->lb : 0;
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
    const struct basic *b = told_basic(t->l, type);
    const struct type *d = b ? NULL : told_type(t->l, type);
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

/* How much of a buffer: `count` elements; for each rank (or neighbour) as many; for each as arrays say, at
 * places in elements, or in bytes with types of their own, ints or MPI_Aints; the sum of an array over the
 * own group; of it the own rank's. */
enum amount { NONE, ONE, EACH, LISTED, LISTED_TYPES, LISTED_ADDRESSES, SUM, OWN };

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
    {"Neighbor_allgather", ONE, EACH, false, false, false},
    {"Neighbor_allgatherv", ONE, LISTED, false, false, false},
    {"Neighbor_alltoall", EACH, EACH, false, false, false},
    {"Neighbor_alltoallv", LISTED, LISTED, false, false, false},
    {"Neighbor_alltoallw", LISTED_ADDRESSES, LISTED_ADDRESSES, false, false, false},
};

/* Parts of a call's buffers. */
struct parts {
    int outs, ins;     /* so many go out, and come in */
    int members, rank; /* of the own group */
};

static struct parts parts_of(const struct comm *c, bool of_neighbours)
{
    const struct group *g = c->remote ? c->remote : c->local;
    const struct topology *t = of_neighbours ? c->topology : NULL;
    struct parts p = {g->size, g->size, c->local->size, c->local->rank};
    if (t && t->kind == MPI_CART)
        p.outs = p.ins = 2 * t->dims;
    else if (t && t->kind == MPI_GRAPH)
        p.outs = p.ins = t->ends[p.rank] - (p.rank ? t->ends[p.rank - 1] : 0);
    else if (t)
        p.outs = t->outs, p.ins = t->edge_count;
    return p;
}

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

/* Where the i-th part lies, in bytes. */
static MPI_Aint place_of(const struct teller *t, const struct names *k, enum amount amount, int i)
{
    const void *at = (const void *)argument(t, k->at);
    if (amount == LISTED_ADDRESSES)
        return ((const MPI_Aint *)at)[i];
    MPI_Aint place = ((const int *)at)[i];
    return amount == LISTED ? place * extent_of(t->l, argument(t, k->type)) : place;
}

static void tell_listed(const struct teller *t, const struct names *k, enum amount amount, int parts,
                        bool write)
{
    uintptr_t buf = argument(t, k->buf), type = argument(t, k->type);
    const int *counts = (const int *)argument(t, k->counts);
    const MPI_Datatype *types = (const MPI_Datatype *)argument(t, k->types);
    if (!counts || !argument(t, k->at) || buf == (uintptr_t)MPI_IN_PLACE)
        return;
    for (int i = 0; i < parts; i++)
        tell_elements(t, buf + (uintptr_t)place_of(t, k, amount, i), counts[i],
                      amount == LISTED ? type : (uintptr_t)types[i], write, true);
}

static int count_of(const struct teller *t, const struct names *k, enum amount amount, const struct parts *p,
                    int parts)
{
    int count = (int)argument(t, k->count), sum = 0;
    const int *counts = (const int *)argument(t, k->counts);
    if (amount == ONE || amount == EACH)
        return amount == EACH ? count * parts : count;
    if (!counts)
        return 0;
    for (int i = 0; i < p->members; i++)
        sum += counts[i];
    return amount == SUM ? sum : counts[p->rank];
}

static void tell_part(const struct teller *t, const struct names *k, enum amount amount,
                      const struct parts *p, bool write)
{
    int parts = write ? p->ins : p->outs;
    if (amount == LISTED || amount == LISTED_TYPES || amount == LISTED_ADDRESSES)
        tell_listed(t, k, amount, parts, write);
    else if (amount != NONE)
        tell_elements(t, argument(t, k->buf), count_of(t, k, amount, p, parts), argument(t, k->type), write,
                      true);
}

/* A receive, or the part of Sendrecv that is one. */
static void tell_receive(const struct teller *t, const struct names *k)
{
    if (told_int(t->c, "source", MPI_PROC_NULL) != MPI_PROC_NULL)
        tell_elements(t, argument(t, k->buf), (int)argument(t, k->count), argument(t, k->type), true, false);
}

/* Is this rank the call's root, and one of those whom the root sends to or gets from? In a call without a
 * root each is both. Of two groups, the ranks beside the root are neither. */
struct role {
    bool root, other;
};

static struct role role_in(const struct nxm_told *c, const struct comm *comm)
{
    uintptr_t root;
    if (!told_argument(c, "root", &root))
        return (struct role){true, true};
    if (comm->remote)
        return (struct role){(int)root == MPI_ROOT, (int)root >= 0};
    return (struct role){(int)root == comm->local->rank, true};
}

static void tell_shape(const struct teller *t, const struct shape *s, const struct comm *comm)
{
    struct parts p = parts_of(comm, strncmp(s->stem, "Neighbor", sizeof "Neighbor" - 1) == 0);
    struct role is = role_in(t->c, comm);
    bool reads = s->root_reads ? is.root : is.other, writes = s->root_writes ? is.root : is.other;
    if (reads && told_int(t->c, "dest", 0) != MPI_PROC_NULL)
        tell_part(t, &from, s->reads, &p, false);
    if (strcmp(s->stem, "Sendrecv") == 0)
        tell_receive(t, &into);
    else if (strcmp(s->stem, "Sendrecv_replace") == 0)
        tell_receive(t, &from);
    else if (writes)
        tell_part(t, s->reduces ? &result : &into, s->writes, &p, true);
}

static void tell_broadcast(const struct teller *t, const struct comm *comm)
{
    struct parts p = parts_of(comm, false);
    struct role is = role_in(t->c, comm);
    if (is.root || is.other)
        tell_part(t, &from, ONE, &p, !is.root);
}

void told_accesses(const struct nxm_library *l, const struct nxm_told *c, told_access_fn *f, void *ctx)
{
    const struct teller t = {l, c, f, ctx};
    const struct comm *comm = told_comm(l, c);
    const char *stem = told_stem(c);
    if (!comm)
        return;
    if (strcmp(stem, "Recv") == 0)
        tell_receive(&t, &from);
    if (strcmp(stem, "Bcast") == 0)
        tell_broadcast(&t, comm);
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
        if (strcmp(stem, shapes[i].stem) == 0)
            tell_shape(&t, &shapes[i], comm);
}
