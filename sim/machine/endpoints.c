/* endpoints.c - see endpoints.h. An address is a node's, a service's, or the host's (topo.h). m->serves
 * tells the messages between a node and a service, in both directions. */
#include "machine/endpoints.h"
#include "cfs/cfs.h"
#include "cfs/post.h"
#include "machine/history.h"
#include "os/charge.h"
#include "os/match.h"

static bool is_service(const struct node_system *sys, uint32_t address)
{
    return address >= sys->topo.positions && !topo_is_host(&sys->topo, address);
}

static vtime work(void *ctx, uint32_t address, enum protocol_task task, vtime at, vtime t)
{
    struct node_system *sys = ctx;
    return is_service(sys, address) ? cfs_work(sys->cfs, address, at, t)
                                    : node_work(ctx, address, task, at, t);
}

/* No program runs on a service's processor, so moving bytes is work like any other. */
static void move(void *ctx, uint32_t address, enum protocol_task task, vtime at, vtime t)
{
    struct node_system *sys = ctx;
    if (is_service(sys, address))
        cfs_work(sys->cfs, address, at, t);
    else
        node_move(ctx, address, task, at, t);
}

static bool envelope(void *ctx, struct message *m, vtime now)
{
    return m->serves ? post_envelope(m, now) : match_envelope(ctx, m, now);
}

static void arrived(void *ctx, struct message *m, vtime now)
{
    history_add(ctx, m, now);
    if (m->serves)
        post_arrived(m, now);
    else
        match_arrived(ctx, m);
}

struct protocol_nodes endpoints_calls(struct node_system *sys)
{
    return (struct protocol_nodes){sys, work, move, envelope, match_sent, arrived};
}
