/* completion.c - see completion.h. */
#include "mpi_api/core/completion.h"
#include "nx_api/calls/msgwait.h"
#include "os/observer.h"

struct nxm_status completion_status(const struct node *n, const struct message *m)
{
    return (struct nxm_status){
        .done = 1, .tag = (int)m->type, .node = (int)nx_sender(n, m), .bytes = (long)m->bytes};
}

void completion_take(struct node *n, struct receive *r, struct nxm_status *status)
{
    *status = completion_status(n, r->m);
    status->truncated = mailbox_take(n, r) < 0;
}

/* How many of the ids are done, and whether all are. */
struct progress {
    int done;
    bool all;
};

static struct progress progress(struct node *n, const struct nxm_completion *c)
{
    struct progress p = {0, true};
    for (int i = 0; i < c->count; i++)
        if (c->ids[i]) {
            bool done = mailbox_id_is_complete(n, c->ids[i]);
            p.done += done;
            p.all = p.all && done;
            if (done && c->how & (NXM_ANY | NXM_SOME))
                break; /* one is enough */
            if (!done && !(c->how & (NXM_ANY | NXM_SOME)))
                break;
        }
    return p;
}

bool completion_is_ready(struct node *n, void *completion)
{
    const struct nxm_completion *c = completion;
    struct progress p = progress(n, c);
    return c->how & (NXM_ANY | NXM_SOME) ? p.done > 0 || p.all : p.all;
}

struct awaited completion_awaits(struct node *n, const struct nxm_completion *c)
{
    for (int i = 0; i < c->count; i++) {
        if (!c->ids[i] || mailbox_id_is_complete(n, c->ids[i]))
            continue;
        const struct receive *r = mailbox_id_receive(n, c->ids[i]);
        const struct send *s = mailbox_id_send(n, c->ids[i]);
        if (r && !r->m)
            return (struct awaited){.receive = r};
        if (s && !s->done)
            return (struct awaited){.send = s};
    }
    return (struct awaited){0};
}

static void take(struct node *n, int id, struct nxm_status *status)
{
    struct receive *r = mailbox_id_receive(n, id);
    if (r)
        completion_take(n, r, status);
    else
        *status = (struct nxm_status){.done = 1};
    mailbox_id_release(n, id);
}

/* Takes those that are done; with NXM_ANY the first. */
static void take_done(struct node *n, const struct nxm_completion *c)
{
    for (int i = 0; i < c->count; i++) {
        bool done = c->ids[i] && mailbox_id_is_complete(n, c->ids[i]);
        c->status[i].done = 0;
        if (!done)
            continue;
        take(n, c->ids[i], &c->status[i]);
        if (c->how & NXM_ANY)
            return;
    }
}

/* What the call is about: its first id, done or not. (A call that is made ahead of its time must not say what
 * depends on the moment.) */
static void tell(struct node *n, const struct nxm_completion *c)
{
    int i = 0;
    while (i < c->count && !c->ids[i])
        i++;
    if (i == c->count)
        return;
    const struct receive *r = mailbox_id_receive(n, c->ids[i]);
    ANNOUNCE(n, awaits, !r, r ? r->select.node : -1);
    gate_awaits(n, r ? (long)r->select.type : mailbox_id_send(n, c->ids[i])->info.type);
}

bool completion_run(struct node *n, const struct nxm_completion *c)
{
    nx_spend_call(n);
    tell(n, c);
    if (c->how & NXM_WAIT) {
        node_wait(n, completion_is_ready, (void *)(uintptr_t)c);
    } else if (!completion_is_ready(n, (void *)(uintptr_t)c)) {
        struct awaited a = completion_awaits(n, c);
        if (a.receive)
            nx_found_nothing(n, &a.receive->select);
        for (int i = 0; i < c->count; i++)
            c->status[i] = (struct nxm_status){.arrived = c->ids[i] && mailbox_id_is_complete(n, c->ids[i])};
        return false;
    }
    if (!(c->how & NXM_LEAVE))
        take_done(n, c);
    return true;
}
