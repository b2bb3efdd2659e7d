/* unison.c - see unison.h. */
#include "cfs/unison.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include "cfs/cfs_state.h"
#include "cfs/operation.h"
#include "kernel/xalloc.h"
#include "lp/engine.h"
#include "os/charge.h"

/* A node of the round. */
struct member {
    struct parcel parcel; /* first: the message with the news */
    struct round *round;
    struct cfs_op *op; /* waits for the news; NULL: has not called yet, or is over */
    bool told;
    vtime at; /* told: from then on */
};

struct round {
    struct cfs *cfs;
    const struct store_file *store;
    uint32_t generation; /* of the file's group */
    uint64_t number;
    struct round_call call;
    uint64_t behind; /* the pointer after the round */
    uint64_t bytes;  /* moved */
    char *data;      /* of a read */
    uint32_t first;  /* the node that reads or writes */
    uint32_t nodes, joined, told;
    struct member *member;
    struct round *next, **link; /* cfs.rounds */
};

static void drop(struct round *r)
{
    if (r->next)
        r->next->link = r->link;
    *r->link = r->next;
    free(r->member);
    free(r->data);
    free(r);
}

/* Frees the round if all nodes have made their calls, and all have the news. */
static void drop_if_over(struct round *r)
{
    if (r->joined == r->nodes && r->told == r->nodes)
        drop(r);
}

void unison_free(struct cfs *c)
{
    while (c->rounds)
        drop(c->rounds);
}

static struct round *find(const struct cfs_file *f)
{
    struct round *r = f->cfs->rounds;
    while (r && (r->store != f->store || r->generation != f->generation || r->number != f->round))
        r = r->next;
    return r;
}

static struct round *begin(const struct cfs_file *f, const struct round_call *call)
{
    struct cfs *c = f->cfs;
    struct round *r = xcalloc(1, sizeof *r);
    *r = (struct round){.cfs = c, .store = f->store, .generation = f->generation, .number = f->round};
    r->call = *call;
    r->nodes = c->sys->count;
    r->member = xcalloc(r->nodes, sizeof *r->member);
    r->next = c->rounds, r->link = &c->rounds;
    if (r->next)
        r->next->link = &r->next;
    return c->rounds = r;
}

static bool same_call(const struct round_call *a, const struct round_call *b)
{
    return a->write == b->write && a->at == b->at && a->asked == b->asked;
}

struct round *unison_join(struct cfs_file *f, const struct round_call *call, bool *first,
                          struct round_call *other)
{
    struct round *r = find(f);
    *first = !r;
    if (!r)
        r = begin(f, call);
    *other = r->call;
    if (!same_call(call, other))
        return NULL;
    f->round++;
    r->joined++;
    return r;
}

uint64_t *unison_pointer(struct round *r)
{
    return &r->behind;
}

/* --- the news --- */

static void forward(struct round *r, uint32_t node, vtime at);

static void tell(struct round *r, uint32_t node, vtime at)
{
    struct member *m = &r->member[node];
    assert(!m->told && r->told < r->nodes);
    m->told = true;
    m->at = at;
    r->told++;
    if (m->op)
        cfs_told(m->op, r->bytes, r->data, at);
    m->op = NULL;
}

static void arrived(struct parcel *parcel, vtime at, vtime now)
{
    struct member *m = (struct member *)parcel;
    struct round *r = m->round;
    uint32_t node = (uint32_t)(m - r->member);
    (void)now;
    forward(r, node, at);
    tell(r, node, at);
    drop_if_over(r);
}

/* Sends one message. A node whose program has ended forwards the news all the same, without time of a
 * program. */
static vtime send(struct round *r, uint32_t from, uint32_t to, vtime at)
{
    struct node_system *s = r->cfs->sys;
    size_t bytes = POST_HEADER + (r->call.write ? 0 : r->bytes);
    struct member *m = &r->member[to];
    m->round = r;
    m->parcel.arrived = arrived;
    if (s->nodes[from]->lp.state != LP_ENDED)
        at = node_work(s, from, PROTOCOL_SEND, at, post_send_time(s->schedule.protocol, POST_EAGER, bytes));
    post_send(s->schedule.protocol, from, to, POST_EAGER, bytes, &m->parcel, at);
    return at;
}

static void forward(struct round *r, uint32_t node, vtime at)
{
    uint32_t rank = (node + r->nodes - r->first) % r->nodes, step = 1;
    while (step < r->nodes)
        step *= 2;
    for (; step > 0 && step > rank; step /= 2)
        if (rank + step < r->nodes)
            at = send(r, node, (rank + step + r->first) % r->nodes, at);
}

void unison_spread(struct round *r, uint32_t node, uint64_t bytes, const char *data, vtime at)
{
    r->first = node;
    r->bytes = bytes;
    if (!r->call.write) {
        r->data = xmalloc(bytes + 1);
        memcpy(r->data, data, bytes);
    }
    forward(r, node, at);
    tell(r, node, at);
    drop_if_over(r);
}

void unison_await(struct round *r, uint32_t node, struct cfs_op *op, vtime now)
{
    struct member *m = &r->member[node];
    if (m->told)
        cfs_told(op, r->bytes, r->data, vt_max(m->at, now));
    else
        m->op = op;
    drop_if_over(r);
}
