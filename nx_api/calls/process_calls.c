/* process_calls.c - process types, and waiting for the ends of processes. */
#include "nx_api/calls/process_calls.h"

long nxs_setptype(word ptype)
{
    struct node *n = node_self();
    if (ptype < 0)
        return node_error(n, EQPID, "%d is negative", ptype);
    n->pid = ptype;
    return 0;
}

long nxs_setpid(word pid)
{
    return nxs_setptype(pid);
}

/* No back end traps: a program that divides by zero ends with a report. */
long nxs_handler(word trap, void (*f)(void))
{
    (void)trap, (void)f;
    return 0;
}

/* Does a call that waits for `node` (-1: all others) wait for another's end? *e tells of the end. */
static bool is_awaited(const struct node *n, uint32_t other, word node, struct process_end *e)
{
    if (node != ALL_NODES && (uint32_t)node != other)
        return false;
    *e = nx_process_end(n, other);
    return e->awaitable;
}

bool nx_all_have_ended(struct node *n, void *node)
{
    struct process_end e;
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (is_awaited(n, i, *(word *)node, &e) && !e.ended)
            return false;
    return true;
}

/* The end that came first of those that have come, and whose it was. False: none has come. */
static bool first_end(const struct node *n, word node, struct process_end *first, uint32_t *who)
{
    bool found = false;
    struct process_end e;
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (is_awaited(n, i, node, &e) && e.ended && (!found || e.order < first->order))
            found = true, *first = e, *who = i;
    return found;
}

/* Has an awaited program ended? The function writes nothing, since it may be called on another stack than
 * the node's. */
bool nx_one_has_ended(struct node *n, void *node)
{
    struct process_end e;
    uint32_t who;
    return first_end(n, *(word *)node, &e, &who);
}

/* Are there nodes to wait for? */
static long check_awaited(struct node *n, word node)
{
    struct process_end e;
    if (nx_check_node(n, node) < 0)
        return -1;
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (is_awaited(n, i, node, &e))
            return 0;
    return node_error(n, EQNOPROC, "no process to wait for: not one's own, and each once");
}

long nxs_waitall(word node, word pid)
{
    struct node *n = node_self();
    struct process_end e;
    (void)pid;
    if (nx_check_node(n, node) < 0)
        return -1;
    nx_wait_for_end(n, nx_all_have_ended, &node);
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (is_awaited(n, i, node, &e))
            nx_notice_end(n, i);
    return 0;
}

long nxs_waitone(word node, word pid, long *ended, long *ended_pid, long *status)
{
    struct node *n = node_self();
    struct process_end e = {0};
    uint32_t who = 0;
    (void)pid;
    if (check_awaited(n, node) < 0)
        return -1;
    nx_wait_for_end(n, nx_one_has_ended, &node);
    first_end(n, node, &e, &who);
    nx_notice_end(n, who);
    if (ended)
        node_put_long(n, ended, 0, who);
    if (ended_pid)
        node_put_long(n, ended_pid, 0, e.pid);
    if (status)
        node_put_long(n, status, 0, e.status);
    return 0;
}
