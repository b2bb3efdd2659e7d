/* call.c - the two faces of every call, and their errors. See call.h. */
#include "nx_api/calls/call.h"
#include <errno.h>

/* --- checks that several calls make --- */

long nx_check_node(struct node *n, long node)
{
    long count = n->sys->count;
    if (node == count && !n->sys->host)
        return node_error(n, EQNODE, "node %ld is the host, and no host program runs", node);
    if (node != ALL_NODES && (node < 0 || node > count))
        return node_error(n, EQNODE, "there is no node %ld (nodes are 0 to %ld; -1 is all others)", node,
                          count - 1);
    return 0;
}

long nx_check_buffer(struct node *n, const void *buf, long len)
{
    if (len < 0)
        return node_error(n, EQLEN, "length %ld is negative", len);
    if (len > 0 && !buf)
        return node_error(n, EQPBUF, "the buffer is a null pointer");
    return 0;
}

/* --- the faces --- */

static struct node *enter(const char *call)
{
    struct node *n = node_self();
    node_enter(n, call);
    return n;
}

static void leave(struct node *n)
{
    mailbox_settle(n);
    node_leave(n);
}

/* NAME: an error ends the process. */
long nx_plain(struct node *n, long result)
{
    if (result < 0)
        node_fail(n, "%s: %s", n->call, n->error.text);
    leave(n);
    return result;
}

/* _NAME: an error is the program's to see. */
long nx_returning(struct node *n, long result)
{
    int why = n->error.code;
    leave(n);
    if (result < 0)
        errno = why;
    return result;
}

#define NX_CALL(name, parameters, arguments)                                                                 \
    long node_##name parameters                                                                              \
    {                                                                                                        \
        struct node *self = enter(#name);                                                                    \
        return nx_plain(self, nxs_##name arguments);                                                         \
    }                                                                                                        \
    long node__##name parameters                                                                             \
    {                                                                                                        \
        struct node *self = enter("_" #name);                                                                \
        return nx_returning(self, nxs_##name arguments);                                                     \
    }
#define NX_VALUE(name, expression)                                                                           \
    long node_##name(void)                                                                                   \
    {                                                                                                        \
        const struct node *n = node_self();                                                                  \
        return expression;                                                                                   \
    }                                                                                                        \
    long node__##name(void)                                                                                  \
    {                                                                                                        \
        return node_##name();                                                                                \
    }
#define NX_OTHER(name)
#include "nx_api/calls/calls.def"
