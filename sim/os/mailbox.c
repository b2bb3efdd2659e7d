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
#include "os/observer.h"
#include "os/order_policy.h"
#include "os/unexpected.h"
#include "os/fail.h"

struct mailbox_ids *mailbox_ids(const struct node *n)
{
    return (struct mailbox_ids *)&n->mailbox.ids;
}

inline void mailbox_post(struct node *n, struct receive *r)
{
    ANNOUNCE(n, posts, r);
    if (IS_HEARD(n, posts_special) && (r->select.type < 0 || r->select.node >= 0 || r->handler))
        ANNOUNCE(n, posts_special, r);
    front_post(n, r);
}

bool mailbox_withdraw(struct node *n, struct receive *r)
{
    ANNOUNCE(n, withdraws, r);
    return match_withdraw(n, r);
}

void mailbox_serve_posted(struct node *n)
{
    match_serve_posted(n, node_now(n));
}

bool mailbox_complete(struct node *n, const struct receive *r)
{
    if (!r->m || r->complete > n->lp.clock.now) /* which stands still: the program is in a call */
        return false;
    prefetch_pair(r->m); /* it is read soon, and is in no cache */
    return true;
}

inline long mailbox_take(struct node *n, struct receive *r)
{
    struct message *m = r->m;
    m->too_long = !matching_fits(r);
    if (!m->too_long && __builtin_expect(n->asan != NULL, 0)) /* a handler's comes during any call, or none */
        asan_in_library(n, r->handler ? NULL : n->call.name, true, r->buf, m->bytes,
                        __builtin_frame_address(0));
    long result = matching_take(n, r);
    ANNOUNCE(n, takes, r);
    if (IS_HEARD(n, takes_special) && (r->select.type < 0 || r->select.node < 0 || r->handler))
        ANNOUNCE(n, takes_special, r);
    r->m = NULL;
    m->receive = NULL;
    front_received(n, m);
    return result;
}

const struct message *mailbox_probe(struct node *n, const struct selector *select)
{
    const struct order_policy *orders = order_policy_of(n);
    const struct message *m = orders ? orders->probe(n, select) : unexpected_first(n, select);
    return m && (m->in_order || (m->whole && m->complete <= node_now(n))) ? m : NULL;
}

void mailbox_drop(struct receive *r)
{
    if (r->m && r->m->arrived)
        protocol_message_free(r->m);
}

void mailbox_unfollow(struct send *s)
{
    struct node *n = node_self();
    ANNOUNCE(n, sent, s);
    match_unfollow(s);
}
