/* mpi_processes.c - the ends of processes. Each node runs one; mpirun starts them all. */
#include <errno.h>
#include <sys/syscall.h>
#include <unistd.h>
#include "nx_api/calls/call.h"
#include "nx_api/mpi/mpi_end.h"
#include "nx_api/mpi/mpi_node.h"
#include "nx_api/mpi/mpi_wire.h"

long nxs_killcube(word node, word pid)
{
    struct node *n = node_self();
    (void)node, (void)pid;
    wire_send(n, ALL_NODES, (struct wire_head){.kind = WIRE_KILL}, NULL, 0);
    mpi_end_here(n);
}

long nxs_killproc(word node, word pid)
{
    struct node *n = node_self();
    if (node == ALL_NODES)
        return nxs_killcube(node, pid);
    if (nx_check_victim(n, node) < 0)
        return -1;
    if (node == (word)n->id) {
        n->killed_alone = true;
        mpi_end_here(n);
    }
    wire_send(n, node, (struct wire_head){.kind = WIRE_KILL, .type = 1}, NULL, 0);
    return 0;
}

/* kill(2), by which a Paragon program ends itself: 0 and -1 are all its processes. */
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

struct process_end nx_process_end(const struct node *n, uint32_t node)
{
    const struct mpi_end *e = &n->ends[node];
    return (struct process_end){
        .awaitable = node != (uint32_t)n->id && !e->noticed,
        .ended = e->ended,
        .order = e->order,
        .pid = e->pid,
        .status = e->status,
    };
}

void nx_notice_end(struct node *n, uint32_t node)
{
    n->ends[node].noticed = true;
}

void nx_wait_for_end(struct node *n, bool (*ready)(struct node *, void *), void *arg)
{
    node_wait(n, ready, arg);
}
