/* mailbox.c - what NX's calls do with a node's messages: nx_api/contract/message.h, on the simulator. */
#include "nx_api/contract/message.h"
#include <string.h>
#include "kernel/prefetch.h"
#include "node/system.h"
#include "nx_api/contract/ids.h"
#include "nx_api/contract/matching.h"
#include "os/end.h"
#include "os/front.h"
#include "os/gate.h"
#include "nx_api/contract/backend.h"
#include "os/asan_hooks.h"
#include "os/match.h"
#include "os/node_record.h"
#include "os/taken.h"
#include "os/numbering.h"
#include "os/orders.h"
#include "os/race_hooks.h"
#include "os/unexpected.h"
#include "os/fail.h"

struct mailbox_ids *mailbox_ids(const struct node *n)
{
    return (struct mailbox_ids *)&n->mailbox.ids;
}

void mailbox_post(struct node *n, struct receive *r)
{
    if (r->select.node >= 0)
        n->names_senders = true;
    RACES(n, posts, r);
    front_post(n, r);
}

void mailbox_withdraw(struct node *n, struct receive *r)
{
    RACES(n, withdraws, r);
    match_withdraw(n, r);
}

bool mailbox_complete(struct node *n, const struct receive *r)
{
    if (!r->m || r->complete > node_now(n))
        return false;
    prefetch_pair(r->m); /* it is read soon, and is in no cache */
    return true;
}

long mailbox_take(struct node *n, struct receive *r)
{
    struct message *m = r->m;
    m->too_long = !matching_fits(r);
    RACES(n, takes, r);
    if (!m->too_long)
        ASAN_CALL(n, true, r->buf, m->bytes);
    long result = matching_take(n, r);
    r->m = NULL;
    m->receive = NULL;
    RECORD(n, takes, m);
    if (taken_matters(n, r))
        taken_note(n, r, m);
    NUMBER(n, take, r);
    front_received(n, m);
    return result;
}

const struct message *mailbox_probe(struct node *n, const struct selector *select)
{
    const struct message *m = orders_are_kept(n->sys) ? orders_probe(n, select) : unexpected_first(n, select);
    return m && m->whole && m->complete <= node_now(n) ? m : NULL;
}

void mailbox_drop(struct receive *r)
{
    if (r->m && r->m->arrived)
        protocol_message_free(r->m);
}

void mailbox_unfollow(struct send *s)
{
    RACES(node_self(), sent, s);
    match_unfollow(s);
}
