/* send.c - csend, isend, hsend, hsendx, gsendx. */
#include "nx_api/calls/send.h"
#include "nx_api/calls/msgwait.h"

static inline long check_message(struct node *n, const struct outgoing *o)
{
    if (o->type < 0 || o->type > 1999999999)
        return node_error(n, EQTYPE,
                          "type %ld is out of range (0 to 999999999; force types 1073741824 to 1999999999)",
                          o->type);
    return nx_check_buffer(n, o->buf, o->len);
}

long nx_check_send(struct node *n, const struct outgoing *o)
{
    nx_about(n, o->type);
    if (o->node == ALL_NODES)
        node_order(n); /* other nodes forward the message, from now on */
    if (nx_check_node(n, o->node) < 0 || nx_check_way(n, o->node) < 0)
        return -1;
    return check_message(n, o);
}

bool nx_send_is_done(struct node *n, void *send)
{
    (void)n;
    return ((struct send *)send)->done;
}

struct send *nx_own_send(struct node *n)
{
    struct send *s = &nx_own_calls(n)->send[n->in_handler];
    *s = (struct send){0};
    return s;
}

static void follow_and_wait(struct node *n, const struct outgoing *o)
{
    struct send *s = nx_own_send(n);
    nx_send(n, o, s);
    if (!s->done)
        node_wait(n, nx_send_is_done, s);
}

/* Sends, and waits until the buffer may be used again. If it may at once, the program resumes at once: system
 * time between this call and the program's next one delays the program in any case. */
static void send_and_wait(struct node *n, const struct outgoing *o)
{
    if (nx_goes_at_once(n, o))
        nx_send(n, o, NULL);
    else
        follow_and_wait(n, o);
}

long nxs_csend(word type, const void *buf, word len, word node, word pid)
{
    struct node *n = node_self();
    const struct outgoing o = {.type = type, .buf = buf, .len = len, .node = node, .pid = pid};
    if (nx_check_send(n, &o) < 0)
        return -1;
    send_and_wait(n, &o);
    return 0;
}

long nxs_isend(word type, const void *buf, word len, word node, word pid)
{
    struct node *n = node_self();
    const struct outgoing o = {.type = type, .buf = buf, .len = len, .node = node, .pid = pid};
    if (nx_check_send(n, &o) < 0)
        return -1;
    long id = nx_new_id(n, ID_SENDS);
    if (id >= 0)
        nx_send(n, &o, mailbox_id_send(n, id));
    return id;
}

long nxs_hsendx(word type, const void *buf, word len, word node, word pid, mailbox_handler *handler,
                long param)
{
    struct node *n = node_self();
    const struct outgoing o = {.type = type, .buf = buf, .len = len, .node = node, .pid = pid};
    if (nx_check_send(n, &o) < 0)
        return -1;
    if (!handler)
        return node_error(n, EQHND, "the handler is a null pointer");
    nx_spend_kernel(n);
    struct send *s = mailbox_send_handler(n, handler, param);
    s->info = (struct node_info){type, len, node, pid};
    nx_send(n, &o, s);
    return 0;
}

long nxs_hsend(word type, const void *buf, word len, word node, word pid, mailbox_handler *handler)
{
    return nxs_hsendx(type, buf, len, node, pid, handler, 0);
}

/* Sends nothing unless all the nodes exist. */
long nxs_gsendx(word type, const void *buf, word len, const long nodes[], word count)
{
    struct node *n = node_self();
    struct outgoing o = {.type = type, .buf = buf, .len = len};
    nx_about(n, o.type);
    if (check_message(n, &o) < 0)
        return -1;
    if (count < 0)
        return node_error(n, EQLEN, "%d nodes", count);
    if (count > 0 && !nodes)
        return node_error(n, EQPBUF, "the list of nodes is a null pointer");
    for (word i = 0; i < count; i++) {
        word node = (word)node_get_long(n, nodes, (size_t)i);
        if (node == ALL_NODES)
            return node_error(n, EQNODE, "node -1 stands for all others, and has no place in a list");
        if (nx_check_node(n, node) < 0 || nx_check_way(n, node) < 0)
            return -1;
    }
    for (word i = 0; i < count; i++) {
        o.node = (word)node_get_long(n, nodes, (size_t)i);
        send_and_wait(n, &o);
    }
    return 0;
}
