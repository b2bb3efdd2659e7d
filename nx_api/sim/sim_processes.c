/* sim_processes.c - the ends of processes. Each node runs one; without a host program all are loaded before
 * the first starts. */
#include <errno.h>
#include "machine/cube.h"
#include "nx_api/calls/call.h"
#include "os/end.h"

/* --- ending --- */

/* Kills in the cube of a host program, which itself keeps running. */
static long kill_in_cube(struct node *n, word node, bool flush)
{
    if (nx_check_victim(n, node) < 0)
        return -1;
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
    if (nx_check_victim(n, node) < 0)
        return -1;
    if (node == (word)n->id)
        node_end_here(n, NODE_KILLED, 0);
    node_end_other(n, n->sys->nodes[node]);
    nx_spend_call(n);
    return 0;
}

/* kill(2) of others, by which a Paragon program ends itself: 0 and -1 are all its processes, and no other
 * process exists. */
int node_nx_kill(int pid, int sig)
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

struct process_end nx_process_end(const struct node *n, uint32_t node)
{
    const struct node *other = n->sys->nodes[node];
    return (struct process_end){
        .awaitable = other != n && !other->end.noticed && other->end.how != NODE_NOT_LOADED,
        .ended = other->lp.state == LP_ENDED,
        .order = other->stats.ended_at,
        .pid = other->pid,
        .status = other->end.exit_code,
    };
}

void nx_notice_end(struct node *n, uint32_t node)
{
    node_notice_end(n->sys->nodes[node]);
}

void nx_wait_for_end(struct node *n, bool (*ready)(struct node *, void *), void *arg)
{
    nx_spend_call(n);
    node_order(n);
    node_awaits_end(n, true);
    node_wait(n, ready, arg);
    node_awaits_end(n, false);
}
