/* core.c - see core.h: MPI's messages, on a node's mailbox. */
#include "mpi_api/core/core.h"
#include <stdint.h>
#include "mpi_api/core/completion.h"
#include "nx_api/calls/msgwait.h"
#include "nx_api/calls/probe.h"
#include "nx_api/calls/receive.h"
#include "nx_api/calls/send.h"
#include "nx_api/contract/matching.h"
#include "os/gate.h"

static const char *const names[] = {
#define MPI_DECLARE(name, parameters) "MPI_" #name,
#include "mpi_api/include/mpi_calls.h"
#undef MPI_DECLARE
};

const char *completion_call_name(int call)
{
    return call >= 0 && call < CALL_Other ? names[call] : "MPI";
}

static struct node *enter(int call)
{
    struct node *n = node_self();
    node_enter(n, completion_call_name(call));
    nx_begins_call(n);
    return n;
}

static struct node *enter_early(int call)
{
    struct node *n = node_self();
    node_enter_early(n, completion_call_name(call));
    nx_begins_call(n);
    return n;
}

static struct node *enter_asking(int call)
{
    struct node *n = node_self();
    node_enter_asking(n, completion_call_name(call));
    nx_begins_call(n);
    return n;
}

/* For reports. A collective's tag is the library's own: waits are not told apart by it. */
static void about(struct node *n, const struct nxm_envelope *e)
{
    gate_about(n, e->tag);
    if (!nxm_is_collective(e->context))
        gate_awaits(n, e->tag);
}

/* --- sending --- */

/* The library numbers contexts in an int, each node's so far apart as there are nodes (lib/comms.c): they can
 * run out. A length is negative if a program's count is, or a product of counts does not fit an int. */
static __attribute__((noinline, cold)) void fail_outgoing(struct node *n, const struct nxm_envelope *e)
{
    if (e->context >= 0)
        node_fail(n, "%s: a count is negative, or the parts that the rank passes on have 2 GB", n->call.name);
    node_fail(
        n,
        "%s: the communicator's number is too large: with %u processes, each can begin %u communicators, "
        "windows and files in all: reuse them",
        n->call.name, n->sys->count, (INT32_MAX - NXM_FIRST_CONTEXT) / 2 / n->sys->count);
}

static struct outgoing outgoing_of(struct node *n, const struct nxm_envelope *e, const void *buf, long len,
                                   int held)
{
    if ((e->context | len) < 0)
        fail_outgoing(n, e);
    return (struct outgoing){.type = e->tag,
                             .buf = buf,
                             .len = len,
                             .node = e->node,
                             .pid = e->context,
                             .in_order = true,
                             .held = held != 0};
}

long node_nxm_send(const struct nxm_envelope *e, const void *buf, long len, int held);
long node_nxm_send(const struct nxm_envelope *e, const void *buf, long len, int held)
{
    struct node *n = enter_early(e->call);
    const struct outgoing o = outgoing_of(n, e, buf, len, held);
    about(n, e);
    if (nx_goes_at_once(n, &o)) {
        nx_send(n, &o, NULL);
    } else {
        struct send *s = nx_own_send(n);
        nx_send(n, &o, s);
        if (!s->done)
            node_wait(n, nx_send_is_done, s);
    }
    node_leave(n);
    return 0;
}

/* Ids that are not sends of isend and kin, or of NX's calls, do not run out. */
static long new_id(struct node *n, unsigned use)
{
    return mailbox_id_new(n, use, INT32_MAX);
}

long node_nxm_isend(const struct nxm_envelope *e, const void *buf, long len, int held);
long node_nxm_isend(const struct nxm_envelope *e, const void *buf, long len, int held)
{
    struct node *n = enter_early(e->call);
    const struct outgoing o = outgoing_of(n, e, buf, len, held);
    long id = 0;
    about(n, e);
    if (!nx_goes_at_once(n, &o))
        id = new_id(n, ID_SENDS);
    struct send *s = id ? mailbox_id_send(n, id) : NULL;
    if (s)
        s->info = (struct node_info){.type = e->tag, .pid = e->context};
    nx_send(n, &o, s);
    node_leave(n);
    return id;
}

/* --- receiving --- */

static struct selector selector_of(const struct nxm_envelope *e)
{
    return (struct selector){e->tag, e->node, e->context};
}

static void post(struct node *n, struct receive *r, const struct nxm_envelope *e, void *buf, long room)
{
    about(n, e);
    *r = (struct receive){.select = selector_of(e), .buf = buf, .room = (size_t)room};
    nx_spend_call(n);
    mailbox_post(n, r);
}

long node_nxm_recv(const struct nxm_envelope *e, void *buf, long room, struct nxm_status *status);
long node_nxm_recv(const struct nxm_envelope *e, void *buf, long room, struct nxm_status *status)
{
    struct node *n = enter_early(e->call);
    struct receive *r = nx_own_receive(n);
    post(n, r, e, buf, room);
    node_wait(n, nx_receive_is_complete, r);
    completion_take(n, r, status);
    node_leave(n);
    return 0;
}

long node_nxm_irecv(const struct nxm_envelope *e, void *buf, long room);
long node_nxm_irecv(const struct nxm_envelope *e, void *buf, long room)
{
    struct node *n = enter_early(e->call);
    long id = new_id(n, ID_RECEIVES);
    post(n, mailbox_id_receive(n, id), e, buf, room);
    node_leave(n);
    return id;
}

long node_nxm_receive_into(int id, void *buf, long room);
long node_nxm_receive_into(int id, void *buf, long room)
{
    struct receive *r = mailbox_id_receive(node_self(), id);
    r->buf = buf, r->room = (size_t)room;
    return 0;
}

long node_nxm_probe(const struct nxm_envelope *e, int wait, struct nxm_status *status);
long node_nxm_probe(const struct nxm_envelope *e, int wait, struct nxm_status *status)
{
    struct node *n = wait ? enter(e->call) : enter_asking(e->call);
    struct incoming in = {.select = selector_of(e)};
    about(n, e);
    if (!wait)
        node_answers(n, nx_probe_finds(n, &in));
    nx_spend_call(n);
    if (wait)
        node_wait(n, nx_probe_finds, &in);
    const struct message *m = mailbox_probe(n, &in.select);
    if (m)
        *status = completion_status(n, m);
    else
        nx_found_nothing(n, &in.select);
    node_leave(n);
    return m != NULL;
}

long node_nxm_cancel(int call, int id);
long node_nxm_cancel(int call, int id)
{
    struct node *n = enter(call);
    struct receive *r = mailbox_id_receive(n, id);
    bool withdraws = r && !r->m;
    nx_spend_call(n);
    if (withdraws) {
        mailbox_withdraw(n, r);
        mailbox_id_release(n, id);
    }
    node_leave(n);
    return withdraws;
}

/* --- others --- */

long node_nxm_complete(const struct nxm_completion *c);
long node_nxm_complete(const struct nxm_completion *c)
{
    bool waits = c->how & NXM_WAIT;
    struct node *n = waits ? enter_early(c->call) : enter_asking(c->call);
    bool done = completion_run(n, c);
    node_leave(n);
    return done;
}

long node_nxm_fail(int call, const char *text);
long node_nxm_fail(int call, const char *text)
{
    struct node *n = enter(call);
    node_fail(n, "%s: %s", n->call.name, text);
}

long node_nxm_number(enum nxm_number which);
long node_nxm_number(enum nxm_number which)
{
    const struct node *n = node_self();
    const struct cfg_machine *m = n->sys->cfg;
    return (long)(which == NXM_EAGER_LIMIT   ? m->mpi_eager_limit
                  : which == NXM_COLLECTIVES ? m->mpi_collectives
                                             : n->cold->program);
}
