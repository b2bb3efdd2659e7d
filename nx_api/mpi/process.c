/* process.c - processes, one on each node, and their ends. mpirun starts them all. */
#include <errno.h>
#include <sys/syscall.h>
#include <unistd.h>
#include "nx_api/calls/call.h"
#include "nx_api/mpi/wire.h"

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

/* Traps are the operating system's: a program that divides by zero ends. */
long nxs_handler(word trap, void (*f)(void))
{
    (void)trap, (void)f;
    return 0;
}

/* --- ending --- */

long nxs_killcube(word node, word pid)
{
    struct node *n = node_self();
    (void)node, (void)pid;
    wire_send(n, ALL_NODES, (struct wire_head){.kind = WIRE_KILL}, NULL, 0);
    node_end_here(n);
}

long nxs_killproc(word node, word pid)
{
    struct node *n = node_self();
    if (node == ALL_NODES)
        return nxs_killcube(node, pid);
    if (node < 0 || node >= (word)n->sys->count)
        return node_error(n, EQNODE, "there is no node %d (nodes are 0 to %u; -1 is all)", node,
                          n->sys->count - 1);
    if (node == (word)n->id)
        node_end_here(n);
    wire_send(n, node, (struct wire_head){.kind = WIRE_KILL}, NULL, 0);
    return 0;
}

/* kill(2), with which a Paragon program ends itself: 0 and -1 are all its processes. */
int node_kill(int pid, int sig) NX_EXPORT("kill");
int node_kill(int pid, int sig)
{
    if (pid != 0 && pid != -1)
        return (int)syscall(SYS_kill, pid, sig);
    if (sig == 0)
        return 0;
    node_enter(node_self(), "kill");
    nxs_killcube(ALL_NODES, 0);
    return 0;
}

/* --- waiting for ends --- */

static bool is_meant(const struct node *n, uint32_t other, word node)
{
    return other != (uint32_t)n->id && !n->ends[other].noticed &&
           (node == ALL_NODES || (uint32_t)node == other);
}

static bool all_have_ended(struct node *n, void *arg)
{
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (is_meant(n, i, *(word *)arg) && !n->ends[i].ended)
            return false;
    return true;
}

struct awaited {
    word node; /* or all others */
    bool found;
    uint32_t who;
};

static bool one_has_ended(struct node *n, void *arg)
{
    struct awaited *a = arg;
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (is_meant(n, i, a->node) && n->ends[i].ended &&
            (!a->found || n->ends[i].order < n->ends[a->who].order))
            a->found = true, a->who = i;
    return a->found;
}

/* Are there nodes to wait for? */
static long check(struct node *n, word node)
{
    if (nx_check_node(n, node) < 0)
        return -1;
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (is_meant(n, i, node))
            return 0;
    return node_error(n, EQNOPROC, "no process to wait for: not one's own, and each once");
}

long nxs_waitall(word node, word pid)
{
    struct node *n = node_self();
    (void)pid;
    if (nx_check_node(n, node) < 0)
        return -1;
    node_wait(n, all_have_ended, &node);
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (is_meant(n, i, node))
            n->ends[i].noticed = true;
    return 0;
}

long nxs_waitone(word node, word pid, long *ended, long *ended_pid, long *status)
{
    struct node *n = node_self();
    struct awaited a = {.node = node};
    (void)pid;
    if (check(n, node) < 0)
        return -1;
    node_wait(n, one_has_ended, &a);
    n->ends[a.who].noticed = true;
    if (ended)
        node_put_long(n, ended, 0, a.who);
    if (ended_pid)
        node_put_long(n, ended_pid, 0, n->ends[a.who].pid);
    if (status)
        node_put_long(n, status, 0, n->ends[a.who].status);
    return 0;
}
