/* process.c - processes, one on each node, and their ends. Without a host program all are loaded before the first starts. */
#include "nx_api/sim/call.h"
#include <errno.h>
#include "machine/cube.h"
#include "node/self.h"
#include "os/end.h"
#include "os/fail.h"
#include "os/gate.h"
#include "os/longs.h"

/* --- their numbers --- */

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

/* --- what the processor or a host would do --- */

/* Traps are not simulated: a program that divides by zero or loses its way ends with a report. */
long nxs_handler(word trap, void (*f)(void))
{
    (void)trap, (void)f;
    return 0;
}

/* --- ending --- */

/* There is a host program, which goes on. */
static long kill_in_cube(struct node *n, word node, bool flush)
{
    if (node != ALL_NODES && (node < 0 || node >= (word)n->sys->count))
        return node_error(n, EQNODE, "there is no node %d (nodes are 0 to %ld; -1 is all)", node,
                          (long)n->sys->count - 1);
    cube_kill(n, node, flush);
    if (!n->is_host && (node == ALL_NODES || node == (word)n->id))
        node_end_here(n, NODE_KILLED, 0);
    return 0;
}

long nxs_killcube(word node, word pid)
{
    struct node *n = node_self();
    (void)node, (void)pid;
    if (n->sys->cube)
        return kill_in_cube(n, node, true);
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (i != n->id)
            node_end_other(n, n->sys->nodes[i]);
    schedule_stop(&n->sys->schedule, STOP_KILLED, (struct instant){0});
    node_end_here(n, NODE_KILLED, 0);
}

long nxs_killproc(word node, word pid)
{
    struct node *n = node_self();
    if (n->sys->cube)
        return kill_in_cube(n, node, false);
    if (node == ALL_NODES)
        return nxs_killcube(node, pid);
    if (node < 0 || node >= (word)n->sys->count)
        return node_error(n, EQNODE, "there is no node %d (nodes are 0 to %u; -1 is all)", node,
                          n->sys->count - 1);
    if (node == (word)n->id)
        node_end_here(n, NODE_KILLED, 0);
    node_end_other(n, n->sys->nodes[node]);
    nx_spend_call(n);
    return 0;
}

/* kill(2), with which a Paragon program ends itself: 0 and -1 are all its processes, and there is no other. */
int node_kill(int pid, int sig)
{
    struct node *n = node_self();
    if (pid == 0 || pid == -1) {
        if (sig == 0)
            return 0;
        node_enter(n, "kill");
        nxs_killcube(ALL_NODES, 0);
    }
    errno = ESRCH;
    return -1;
}

/* --- waiting for ends --- */

static bool is_meant(const struct node *n, const struct node *other, word node)
{
    return other != n && !other->end_noticed && other->end != NODE_NOT_LOADED &&
           (node == ALL_NODES || node == (word)other->id);
}

/* Of those meant the first that has ended. NULL: none. */
static struct node *first_ended(const struct node *n, word node)
{
    struct node *first = NULL;
    for (uint32_t i = 0; i < n->sys->count; i++) {
        struct node *other = n->sys->nodes[i];
        if (is_meant(n, other, node) && other->lp.state == LP_ENDED &&
            (!first || other->stats.ended_at < first->stats.ended_at))
            first = other;
    }
    return first;
}

static bool one_has_ended(struct node *n, void *node)
{
    return first_ended(n, *(word *)node);
}

static bool all_have_ended(struct node *n, void *arg)
{
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (is_meant(n, n->sys->nodes[i], *(word *)arg) && n->sys->nodes[i]->lp.state != LP_ENDED)
            return false;
    return true;
}

/* Are there nodes to wait for? */
static long check(struct node *n, word node)
{
    if (nx_check_node(n, node) < 0)
        return -1;
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (is_meant(n, n->sys->nodes[i], node))
            return 0;
    return node_error(n, EQNOPROC, "no process to wait for: not one's own, and each once");
}

static void wait_for_end(struct node *n, bool (*ready)(struct node *, void *), void *arg)
{
    nx_spend_call(n);
    node_order(n);
    n->awaits_end = true;
    n->sys->await_ends++;
    node_wait(n, ready, arg);
    n->awaits_end = false;
    n->sys->await_ends--;
}

long nxs_waitall(word node, word pid)
{
    struct node *n = node_self();
    (void)pid;
    if (nx_check_node(n, node) < 0)
        return -1;
    wait_for_end(n, all_have_ended, &node);
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (is_meant(n, n->sys->nodes[i], node))
            n->sys->nodes[i]->end_noticed = true;
    return 0;
}

long nxs_waitone(word node, word pid, long *ended, long *ended_pid, long *status)
{
    struct node *n = node_self();
    (void)pid;
    if (check(n, node) < 0)
        return -1;
    wait_for_end(n, one_has_ended, &node);
    struct node *found = first_ended(n, node);
    found->end_noticed = true;
    if (ended)
        node_put_long(n, ended, 0, found->id);
    if (ended_pid)
        node_put_long(n, ended_pid, 0, found->pid);
    if (status)
        node_put_long(n, status, 0, found->exit_code);
    return 0;
}
