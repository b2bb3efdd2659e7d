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

static bool is_one_enough(int how)
{
    return how & (NXM_ANY | NXM_SOME);
}

static bool is_missing(struct node *n, int id)
{
    return id && !mailbox_id_is_complete(n, id);
}

/* Is one of the ids done, or is there none? */
static bool any_is_done(struct node *n, const struct completion_look *l)
{
    bool none = true;
    for (int i = 0; i < l->count; i++) {
        if (l->ids[i] && mailbox_id_is_complete(n, l->ids[i]))
            return true;
        none = none && !l->ids[i];
    }
    return none;
}

/* Looks first where the last look has found one that is not done: most often it still is not. */
static bool all_are_done(struct node *n, struct completion_look *l)
{
    for (int k = 0, i = l->missing; k < l->count; k++, i = i + 1 < l->count ? i + 1 : 0)
        if (is_missing(n, l->ids[i])) {
            l->missing = i;
            return false;
        }
    return true;
}

bool completion_is_ready(struct node *n, void *look)
{
    struct completion_look *l = look;
    return is_one_enough(l->how) ? any_is_done(n, l) : all_are_done(n, l);
}

struct awaited completion_awaits(struct node *n, const struct completion_look *l)
{
    for (int i = 0; i < l->count; i++) {
        if (!is_missing(n, l->ids[i]))
            continue;
        const struct receive *r = mailbox_id_receive(n, l->ids[i]);
        const struct send *s = mailbox_id_send(n, l->ids[i]);
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
        c->status[i].done = 0;
        if (!c->ids[i] || (is_one_enough(c->how) && is_missing(n, c->ids[i])))
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
    const struct node_info *s = r ? NULL : &mailbox_id_send(n, c->ids[i])->info;
    ANNOUNCE(n, awaits, !r, r ? r->select.node : -1);
    if (!nxm_is_collective(r ? (int)r->select.pid : (int)s->pid))
        gate_awaits(n, r ? (long)r->select.type : s->type);
}

static void begin_look(struct completion_look *l, const struct nxm_completion *c)
{
    l->how = c->how, l->count = c->count, l->missing = 0;
    l->ids = c->ids;
    if (c->count > COMPLETION_FEW)
        return;
    for (int i = 0; i < c->count; i++)
        l->few[i] = c->ids[i];
    l->ids = l->few;
}

bool completion_run(struct node *n, const struct nxm_completion *c)
{
    struct completion_look look;
    begin_look(&look, c);
    bool waits = c->how & NXM_WAIT, ready = waits || completion_is_ready(n, &look);
    if (!waits)
        node_answers(n, ready);
    nx_spend_call(n);
    tell(n, c);
    if (waits) {
        node_wait(n, completion_is_ready, &look);
    } else if (!ready) {
        struct awaited a = completion_awaits(n, &look);
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
