/* exchange.c - csendrecv, isendrecv, hsendrecv: send a message and receive the answer. The receive is posted
 * first, so that the answer finds its buffer. */
#include "nx_api/calls/msgwait.h"
#include "nx_api/calls/receive.h"
#include "nx_api/calls/send.h"

static long check(struct node *n, const struct outgoing *o, const struct incoming *in)
{
    return nx_check_receive(n, in) < 0 ? -1 : nx_check_send(n, o);
}

/* Returns the answer's length. For reports, the call waits for the answer. */
long nxs_csendrecv(word type, const void *buf, word len, word node, word pid, word typesel, void *answer,
                   word room)
{
    struct node *n = node_self();
    const struct outgoing o = {.type = type, .buf = buf, .len = len, .node = node, .pid = pid};
    const struct incoming in = {{typesel, ANY, ANY}, answer, room, NULL};
    if (check(n, &o, &in) < 0)
        return -1;
    struct receive *r = nx_own_receive(n);
    struct send *s = nx_own_send(n);
    nx_set_receive(r, &in);
    nx_spend_call(n);
    mailbox_post(n, r);
    nx_send(n, &o, s);
    node_wait(n, nx_send_is_done, s);
    nx_about(n, typesel);
    node_wait(n, nx_receive_is_complete, r);
    return mailbox_take(n, r) < 0 ? -1 : n->info.count;
}

long nxs_isendrecv(word type, const void *buf, word len, word node, word pid, word typesel, void *answer,
                   word room)
{
    struct node *n = node_self();
    const struct outgoing o = {.type = type, .buf = buf, .len = len, .node = node, .pid = pid};
    const struct incoming in = {{typesel, ANY, ANY}, answer, room, NULL};
    if (check(n, &o, &in) < 0)
        return -1;
    long id = nx_new_id(n, ID_RECEIVES | ID_SENDS);
    if (id < 0)
        return -1;
    nx_spend_call(n);
    struct receive *r = mailbox_id_receive(n, id);
    nx_set_receive(r, &in);
    mailbox_post(n, r);
    nx_send(n, &o, mailbox_id_send(n, id));
    return id;
}

long nxs_hsendrecv(word type, const void *buf, word len, word node, word pid, word typesel, void *answer,
                   word room, mailbox_handler *handler)
{
    struct node *n = node_self();
    const struct outgoing o = {.type = type, .buf = buf, .len = len, .node = node, .pid = pid};
    const struct incoming in = {{typesel, ANY, ANY}, answer, room, NULL};
    if (check(n, &o, &in) < 0 || nx_post_handler(n, &in, handler, 0) < 0)
        return -1;
    nx_about(n, type);
    nx_send(n, &o, NULL);
    return 0;
}
