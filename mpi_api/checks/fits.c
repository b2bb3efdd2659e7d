/* fits.c - see fits.h. */
#include "mpi_api/checks/fits.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "net/protocol.h"
#include "node/node.h"
#include "nx_api/contract/backend.h"
#include "nx_api/waitfor/waitfor_mpi.h"

enum { BUCKETS = 4096 };

struct sent {
    struct sent *next;
    uint32_t from, to;
    int tag, context;
    size_t bytes;
    struct signature signature;
    struct mpi_place place;
};

/* What a member has given a collective. */
struct member {
    uint32_t node;
    struct mpi_place place;
    int root;     /* -1: there is none */
    uintptr_t op; /* one of MPI's; 0: none, or the program's own */
    bool agrees;  /* all members must agree on the bytes, and on the kinds of numbers */
    struct signature signature;
};

struct collective {
    struct collective *next;
    int context, number, come;
    int leader; /* the node of rank 0: the parts of a split communicator have one context */
    struct member first;
};

struct fits {
    struct mpi_findings *all;
    struct sent *sent[BUCKETS];
    struct collective *collectives[BUCKETS];
};

struct fits *fits_new(struct mpi_findings *all)
{
    struct fits *f = xcalloc(1, sizeof *f);
    f->all = all;
    return f;
}

void fits_free(struct fits *f)
{
    for (int i = 0; i < BUCKETS; i++) {
        for (struct sent *s = f->sent[i], *next; s; s = next) {
            next = s->next;
            signature_free(&s->signature);
            free(s);
        }
        for (struct collective *c = f->collectives[i], *next; c; c = next) {
            next = c->next;
            signature_free(&c->first.signature);
            free(c);
        }
    }
    free(f);
}

void fits_node_free(struct fits_node *k)
{
    for (size_t i = 0; i < k->count; i++)
        signature_free(&k->list[i].signature);
    free(k->list);
}

static unsigned bucket(uint64_t a, uint64_t b, uint64_t c, uint64_t d)
{
    uint64_t h = ((a * 31 + b) * 1000003 + c) * 1000003 + d;
    return (unsigned)((h * UINT64_C(0x9e3779b97f4a7c15)) >> 52);
}

/* --- messages --- */

static bool is_point_to_point(long context)
{
    return context >= NXM_FIRST_CONTEXT && (context - NXM_FIRST_CONTEXT) % 2 == 0;
}

/* A persistent request of those that the call starts, for such messages; NULL: there is none. */
static const struct request *started(const struct fits_node *k, bool sends, const struct selector *which)
{
    uintptr_t requests;
    bool one = told_argument(k->call, "request", &requests);
    int count = one ? 1 : told_int(k->call, "count", 0);
    if (strncmp(k->call->name, "MPI_Start", sizeof "MPI_Start" - 1) != 0 ||
        (!one && !told_argument(k->call, "requests", &requests)))
        return NULL;
    for (int i = 0; i < count; i++) {
        const struct request *r =
            (const struct request *)told_object(k->library, ((const uintptr_t *)requests)[i], REQUEST);
        if (r && r->what == (sends ? SENDS : RECEIVES) && r->envelope.tag == which->type &&
            r->envelope.node == which->node && r->envelope.context == which->pid)
            return r;
    }
    return NULL;
}

/* What the call that the program is in sends or receives in messages of so many bytes. (Others are not the
 * program's: of a window, or a file.) */
static struct signature signature(const struct fits_node *k, bool sends, const struct selector *which,
                                  size_t bytes)
{
    struct signature s = {0};
    uintptr_t type;
    if (!k->call)
        return s;
    const struct request *r = started(k, sends, which);
    if (r)
        s = signature_of(k->library, r->count, (uintptr_t)r->type);
    else if (!sends && told_argument(k->call, "as", &type))
        s = signature_of(k->library, told_int(k->call, "room", 0), type);
    else if (told_argument(k->call, "type", &type))
        s = signature_of(k->library, told_int(k->call, "count", 0), type);
    if (s.bytes != bytes)
        signature_free(&s);
    return s;
}

static struct mpi_place place_of(const struct fits_node *k, const struct node *n)
{
    return k->call ? mpi_place(n, k->call) : (struct mpi_place){.call = "MPI", .file = n->guest.file};
}

void fits_sends(struct fits_node *k, struct fits *f, struct node *n, const struct observed_send *what)
{
    for (const struct message *m = what->first; m; m = m->next) {
        if (!is_point_to_point(m->pid))
            continue;
        struct sent **end = &f->sent[bucket(n->id, m->to, (unsigned)m->type, (unsigned)m->pid)];
        while (*end)
            end = &(*end)->next;
        const struct selector which = {m->type, (int)m->to, m->pid};
        *end = xcalloc(1, sizeof **end);
        **end = (struct sent){
            NULL,          n->id, m->to, m->type, m->pid, m->bytes, signature(k, true, &which, m->bytes),
            place_of(k, n)};
    }
}

void fits_posts(struct fits_node *k, struct node *n, const struct receive *r)
{
    if (!is_point_to_point(r->select.pid))
        return;
    if (k->count == k->room)
        k->list = xreallocarray(k->list, k->room = k->room ? 2 * k->room : 8, sizeof *k->list);
    k->list[k->count++] = (struct expected){r, place_of(k, n), signature(k, false, &r->select, r->room)};
}

static struct expected take_posted(struct fits_node *k, const struct receive *r)
{
    for (size_t i = k->count; i-- > 0;)
        if (k->list[i].receive == r) {
            struct expected p = k->list[i];
            k->list[i] = k->list[--k->count];
            return p;
        }
    return (struct expected){0};
}

void fits_withdraws(struct fits_node *k, const struct receive *r)
{
    struct expected p = take_posted(k, r);
    signature_free(&p.signature);
}

static char *communicator(int context)
{
    char *text = NULL;
    size_t size;
    FILE *f = xchecked(open_memstream(&text, &size));
    waitfor_print_communicator(f, context);
    fclose(f);
    return text;
}

/* The receive of a message, with the message. */
static void compare(const struct fits *f, const struct sent *s, const struct expected *p, size_t room)
{
    char *text = NULL, *kinds[2] = {0};
    bool too_long = s->bytes > room;
    if (!p->place.call || (!too_long && !signatures_differ(&s->signature, &p->signature, kinds)))
        return;
    char *in = communicator(s->context);
    if (too_long)
        text = xasprintf("node %u sends %zu bytes, node %u has room for %zu, with tag %d in %s", s->from,
                         s->bytes, s->to, room, s->tag, in);
    else
        text = xasprintf("node %u sends %s, node %u receives %s, with tag %d in %s", s->from, kinds[0], s->to,
                         kinds[1], s->tag, in);
    mpi_findings_add(f->all, too_long ? TOO_LONG : OTHER_TYPES, s->from, &s->place, &p->place, text);
    free(text);
    free(kinds[0]);
    free(kinds[1]);
    free(in);
}

/* The send of a message to a node; NULL: there is none. */
static struct sent *take_sent(struct fits *f, const struct message *m, uint32_t to)
{
    struct sent **link = &f->sent[bucket(m->source, to, (unsigned)m->type, (unsigned)m->pid)];
    while (*link && !((*link)->from == m->source && (*link)->to == to && (*link)->tag == m->type &&
                      (*link)->context == m->pid))
        link = &(*link)->next;
    struct sent *s = *link;
    if (s)
        *link = s->next;
    return s;
}

void fits_gives(struct fits_node *k, struct fits *f, struct node *n, const struct receive *r,
                const struct message *m)
{
    if (!is_point_to_point(m->pid))
        return;
    struct expected p = take_posted(k, r);
    struct sent *s = take_sent(f, m, n->id);
    if (s) {
        compare(f, s, &p, r->buf ? r->room : m->bytes); /* MPI_Mprobe has no buffer yet */
        signature_free(&s->signature);
        free(s);
    }
    signature_free(&p.signature);
}

/* By sender, so that each run tells the same. */
static int by_sender(const void *a, const void *b)
{
    const struct sent *x = *(const struct sent *const *)a, *y = *(const struct sent *const *)b;
    if (x->from != y->from)
        return x->from < y->from ? -1 : 1;
    if (x->to != y->to)
        return x->to < y->to ? -1 : 1;
    return x->tag < y->tag ? -1 : x->tag > y->tag;
}

void fits_report(const struct fits *f)
{
    size_t count = 0, room = 64;
    const struct sent **left = xcalloc(room, sizeof *left);
    for (int i = 0; i < BUCKETS; i++)
        for (const struct sent *s = f->sent[i]; s; s = s->next) {
            if (count == room)
                left = xreallocarray(left, room *= 2, sizeof *left);
            left[count++] = s;
        }
    qsort(left, count, sizeof *left, by_sender);
    for (size_t i = 0; i < count; i++) {
        char *in = communicator(left[i]->context);
        char *text = xasprintf("node %u to node %u, tag %d in %s, %zu bytes", left[i]->from, left[i]->to,
                               left[i]->tag, in, left[i]->bytes);
        mpi_findings_add(f->all, UNRECEIVED, left[i]->from, &left[i]->place, NULL, text);
        free(text);
        free(in);
    }
    free(left);
}

/* --- collectives --- */

/* What all members have to agree on: a buffer's bytes, here that which is sent, received, or either. */
enum part { NO_PART, BUF, INTO, BOTH };
static const struct {
    const char *stem;
    enum part root, others;
} collectives[] = {
    {"Barrier", NO_PART, NO_PART},
    {"Bcast", BUF, BUF},
    {"Reduce", BUF, BUF},
    {"Allreduce", BUF, BUF},
    {"Scan", BUF, BUF},
    {"Exscan", BUF, BUF},
    {"Gather", INTO, BUF},
    {"Scatter", BUF, INTO},
    {"Allgather", BOTH, BOTH},
    {"Alltoall", BOTH, BOTH},
    {"Gatherv", NO_PART, NO_PART},
    {"Scatterv", NO_PART, NO_PART},
    {"Allgatherv", NO_PART, NO_PART},
    {"Alltoallv", NO_PART, NO_PART},
    {"Alltoallw", NO_PART, NO_PART},
    {"Reduce_scatter", NO_PART, NO_PART},
    {"Reduce_scatter_block", BUF, BUF},
};

static void take_part(struct member *m, const struct fits_node *k, bool into)
{
    uintptr_t type;
    m->agrees = told_argument(k->call, into ? "as" : "type", &type);
    if (m->agrees)
        m->signature = signature_of(k->library, told_int(k->call, into ? "room" : "count", 0), type);
}

static bool is_in_place(const struct fits_node *k)
{
    uintptr_t buf;
    return told_argument(k->call, "buf", &buf) && buf == (uintptr_t)MPI_IN_PLACE;
}

static struct member member(const struct fits_node *k, const struct node *n, const struct comm *c,
                            enum part root, enum part others)
{
    struct member m = {.node = n->id, .place = mpi_place(n, k->call), .root = told_int(k->call, "root", -1)};
    enum part part = m.root == c->local->rank ? root : others;
    told_argument(k->call, "op", &m.op);
    m.op = m.op < FIRST_HANDLE ? m.op : 0;
    if (part == INTO || (part == BOTH && is_in_place(k)))
        take_part(&m, k, true);
    else if (part != NO_PART)
        take_part(&m, k, false);
    return m;
}

static const char *ops_name(uintptr_t op)
{
    static const struct {
        uintptr_t op;
        const char *name;
    } names[] = {
#define OP(name) {(uintptr_t)name, #name}
        OP(MPI_SUM),  OP(MPI_MIN),  OP(MPI_MAX), OP(MPI_PROD), OP(MPI_BAND),   OP(MPI_BOR),
        OP(MPI_BXOR), OP(MPI_LAND), OP(MPI_LOR), OP(MPI_LXOR), OP(MPI_MINLOC), OP(MPI_MAXLOC),
#undef OP
    };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (names[i].op == op)
            return names[i].name;
    return "another";
}

/* The first difference; NULL: none. Malloc'd. */
static char *differs(const struct member *a, const struct member *b, enum mpi_finding *kind)
{
    *kind = OTHER_CALLS;
    if (a->place.call != b->place.call)
        return xasprintf("node %u calls %s, node %u %s", a->node, a->place.call, b->node, b->place.call);
    *kind = OTHER_ROOTS;
    if (a->root != b->root)
        return xasprintf("root %d on node %u, %d on node %u", a->root, a->node, b->root, b->node);
    *kind = OTHER_OPS;
    if (a->op && b->op && a->op != b->op)
        return xasprintf("%s on node %u, %s on node %u", ops_name(a->op), a->node, ops_name(b->op), b->node);
    *kind = OTHER_AMOUNTS;
    if (!a->agrees || !b->agrees)
        return NULL;
    if (a->signature.bytes != b->signature.bytes)
        return xasprintf("%zu bytes on node %u, %zu on node %u", a->signature.bytes, a->node,
                         b->signature.bytes, b->node);
    *kind = OTHER_TYPES;
    char *kinds[2];
    if (!signatures_differ(&a->signature, &b->signature, kinds))
        return NULL;
    char *text = xasprintf("%s on node %u, %s on node %u", kinds[0], a->node, kinds[1], b->node);
    free(kinds[0]);
    free(kinds[1]);
    return text;
}

static void compare_members(struct mpi_findings *all, const struct collective *c, const struct member *m)
{
    enum mpi_finding kind;
    char *how = differs(&c->first, m, &kind);
    if (!how)
        return;
    char *of = communicator(c->context);
    char *text = xasprintf("%s, in collective %d of %s", how, c->number, of);
    mpi_findings_add(all, kind, c->first.node, &c->first.place, &m->place, text);
    free(text);
    free(of);
    free(how);
}

/* Where the collective is, or would be. */
static struct collective **find(struct fits *f, int context, int leader, int number)
{
    struct collective **link =
        &f->collectives[bucket(0, (unsigned)leader, (unsigned)context, (unsigned)number)];
    while (*link && !((*link)->context == context && (*link)->leader == leader && (*link)->number == number))
        link = &(*link)->next;
    return link;
}

/* One of the communicator's members has come to a collective, which takes over its signature. */
static void comes(struct fits *f, const struct comm *comm, struct member *m)
{
    const struct group *g = comm->local;
    int number = comm->collectives + 1, leader = g->nodes ? g->nodes[0] : g->first;
    struct collective **link = find(f, comm->context, leader, number);
    if (!*link) {
        *link = xcalloc(1, sizeof **link);
        **link = (struct collective){NULL, comm->context, number, 0, leader, *m};
    } else {
        compare_members(f->all, *link, m);
        signature_free(&m->signature);
    }
    struct collective *c = *link;
    if (++c->come < comm->local->size)
        return;
    *link = c->next;
    signature_free(&c->first.signature);
    free(c);
}

void fits_collective(struct fits_node *k, struct fits *f, struct node *n)
{
    const char *stem = told_stem(k->call);
    const struct comm *comm = told_comm(k->library, k->call);
    if (!comm || comm->remote)
        return;
    for (size_t i = 0; i < sizeof collectives / sizeof *collectives; i++)
        if (strcmp(stem, collectives[i].stem) == 0) {
            node_order(n);
            struct member m = member(k, n, comm, collectives[i].root, collectives[i].others);
            comes(f, comm, &m);
        }
}
