/* system_time.c - the operating system's time on a node's processor, and whose it is: see cpu.h. */
#include "node/cpu.h"
#include "node/system.h"
#include "node/turns.h"

void node_account(struct node *n, enum node_task task, vtime t)
{
    n->stats.tasks[task] += t;
    n->stats.system += t;
}

vtime node_system_time(const struct node *n, vtime t)
{
    return n->system_milli == 1000 ? t : t * n->system_milli / 1000;
}

/* The system has the processor for t, beside or instead of the program. */
static void steal(struct node *n, enum node_task task, vtime t)
{
    if (n->state == NODE_ENDED)
        return; /* nobody's time any more */
    node_catch_up_now(n);
    turn_settle(n, n->sys->present);
    if (n->state == NODE_COMPUTING)
        n->clock.stolen += t;
    node_account(n, task, t);
}

vtime node_work(void *ctx, uint32_t node, enum proto_task task, vtime at, vtime t)
{
    struct node_system *sys = ctx;
    struct node *n = node_at(sys, node);
    t = node_system_time(n, t);
    n->sys_free = vt_max(at, n->sys_free) + t;
    steal(n, task == PROTO_SEND ? NODE_SENDING : NODE_RECEIVING, t);
    return n->sys_free;
}

void node_move(void *ctx, uint32_t node, enum proto_task task, vtime t)
{
    struct node_system *sys = ctx;
    struct node *n = node_at(sys, node);
    steal(n, task == PROTO_SEND ? NODE_FEEDING : NODE_EMPTYING, node_system_time(n, t));
}
