/* receive.c - crecv, irecv, hrecv, and the Paragon's crecvx, irecvx, hrecvx. */
#include "nx_api/calls/receive.h"
#include "nx_api/calls/msgwait.h"

long nx_check_receive(struct node *n, const struct incoming *in)
{
    long node = in->select.node, last = (long)n->sys->count - 1;
    nx_about(n, (long)in->select.type);
    if (node != ANY && (node < 0 || node > last + 1)) /* the host may be selected */
        return node_error(n, EQNODE, "there is no node %ld (nodes are 0 to %ld; -1 is any)", node, last);
    return nx_check_buffer(n, in->buf, in->len);
}

void nx_set_receive(struct receive *r, const struct incoming *in)
{
    *r = (struct receive){.select = in->select, .buf = in->buf, .room = (size_t)in->len, .info = in->info};
}

struct receive *nx_own_receive(struct node *n)
{
    return n->in_handler ? &nx_own_calls(n)->in_handler : &n->receive;
}

bool nx_receive_is_complete(struct node *n, void *receive)
{
    return mailbox_complete(n, receive);
}

long nx_post_handler(struct node *n, const struct incoming *in, mailbox_handler *handler, long param)
{
    if (nx_check_receive(n, in) < 0)
        return -1;
    if (!handler)
        return node_error(n, EQHND, "the handler is a null pointer");
    nx_spend_call(n);
    nx_spend_kernel(n);
    struct receive r;
    nx_set_receive(&r, in);
    r.handler = handler, r.param = param;
    mailbox_post_handler(n, &r);
    return 0;
}

static long receive(const struct incoming *in)
{
    struct node *n = node_self();
    if (nx_check_receive(n, in) < 0)
        return -1;
    struct receive *r = nx_own_receive(n);
    nx_set_receive(r, in);
    nx_spend_call(n);
    mailbox_post(n, r);
    node_wait(n, nx_receive_is_complete, r);
    return mailbox_take(n, r);
}

static long post(const struct incoming *in)
{
    struct node *n = node_self();
    if (nx_check_receive(n, in) < 0)
        return -1;
    long id = nx_new_id(n, ID_RECEIVES);
    if (id < 0)
        return -1;
    nx_spend_call(n);
    struct receive *r = mailbox_id_receive(n, id);
    nx_set_receive(r, in);
    mailbox_post(n, r);
    return id;
}

long nxs_crecv(word typesel, void *buf, word len)
{
    return receive(&(struct incoming){{typesel, ANY, ANY}, buf, len, NULL});
}

long nxs_crecvx(word typesel, void *buf, word len, word node, word pid, long info[])
{
    return receive(&(struct incoming){{typesel, node, pid}, buf, len, info});
}

long nxs_irecv(word typesel, void *buf, word len)
{
    return post(&(struct incoming){{typesel, ANY, ANY}, buf, len, NULL});
}

long nxs_irecvx(word typesel, void *buf, word len, word node, word pid, long info[])
{
    return post(&(struct incoming){{typesel, node, pid}, buf, len, info});
}

long nxs_hrecv(word typesel, void *buf, word len, mailbox_handler *handler)
{
    return nx_post_handler(node_self(), &(struct incoming){{typesel, ANY, ANY}, buf, len, NULL}, handler, 0);
}

long nxs_hrecvx(word typesel, void *buf, word len, word node, word pid, mailbox_handler *handler, long param)
{
    return nx_post_handler(node_self(), &(struct incoming){{typesel, node, pid}, buf, len, NULL}, handler,
                           param);
}
