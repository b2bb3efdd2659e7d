/* mailbox.c - what NX's calls do with a node's messages: nx_api/calls/mailbox.h, on the simulator. */
#include "nx_api/calls/mailbox.h"
#include <string.h>
#include "kernel/prefetch.h"
#include "node/system.h"
#include "nx_api/calls/mailbox_ids.h"
#include "nx_api/include/nxerrno.h"
#include "os/end.h"
#include "os/front.h"
#include "os/gate.h"
#include "os/longs.h"
#include "os/match.h"
#include "os/unexpected.h"
#include "os/fail.h"

struct mailbox_ids *mailbox_ids(const struct node *n)
{
    return (struct mailbox_ids *)&n->mailbox.ids;
}

void mailbox_post(struct node *n, struct receive *r)
{
    front_post(n, r);
}

void mailbox_withdraw(struct node *n, struct receive *r)
{
    match_withdraw(n, r);
}

bool mailbox_complete(struct node *n, const struct receive *r)
{
    if (!r->m || r->complete > node_now(n))
        return false;
    prefetch_pair(r->m); /* it is asked for soon, and nobody has looked at it for long */
    return true;
}

void mailbox_tell(struct node *n, const struct message *m, long info[])
{
    n->info = (struct node_info){(long)m->type, (long)m->bytes, node_number(n->sys, m->source), (long)m->pid};
    const long told[] = {n->info.type, n->info.count, n->info.node, n->info.pid};
    for (size_t i = 0; info && i < sizeof told / sizeof *told; i++)
        node_put_long(n, info, i, told[i]);
}

long mailbox_take(struct node *n, struct receive *r)
{
    struct message *m = r->m;
    long result = 0;
    m->too_long = m->bytes > r->room;
    if (m->too_long)
        result =
            node_error(n, EQMSGLONG, "the message of type %ld from %s has %zu bytes, but the buffer only %zu",
                       (long)m->type, node_at(n->sys, m->source)->name, m->bytes, r->room);
    else if (m->bytes)
        memcpy(r->buf, m->data, m->bytes);
    if (!mailbox_is_library(m->type))
        mailbox_tell(n, m, r->info);
    r->m = NULL;
    m->receive = NULL;
    front_received(n, m);
    return result;
}

const struct message *mailbox_probe(struct node *n, const struct selector *select)
{
    const struct message *m = unexpected_first(n, select);
    return m && m->whole && m->complete <= node_now(n) ? m : NULL;
}

void mailbox_drop(struct receive *r)
{
    if (r->m && r->m->arrived)
        protocol_message_free(r->m);
}

void mailbox_unfollow(struct send *s)
{
    if (s->m)
        s->m->followed = false;
}
