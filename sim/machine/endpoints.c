/* endpoints.c - see endpoints.h. Places are nodes, services, or the host (topo.h); a message between a node
 * and a service is known by m->serves, in both directions. */
#include "machine/endpoints.h"
#include "cfs/cfs.h"
#include "cfs/post.h"
#include "os/charge.h"
#include "os/history.h"
#include "os/match.h"
#include "os/charge.h"

static bool is_service(const struct node_system *sys, uint32_t place)
{
    return place >= sys->topo.positions && !topo_is_host(&sys->topo, place);
}

static vtime work(void *ctx, uint32_t place, enum protocol_task task, vtime at, vtime t)
{
    struct node_system *sys = ctx;
    return is_service(sys, place) ? cfs_work(sys->cfs, place, at, t) : node_work(ctx, place, task, at, t);
}

/* A service's processor is no program's: moving bytes is work like any other. */
static void move(void *ctx, uint32_t place, enum protocol_task task, vtime at, vtime t)
{
    struct node_system *sys = ctx;
    if (is_service(sys, place))
        cfs_work(sys->cfs, place, at, t);
    else
        node_move(ctx, place, task, t);
}

static bool envelope(void *ctx, struct message *m, vtime now)
{
    return m->serves ? post_envelope(m, now) : match_envelope(ctx, m, now);
}

static void arrived(void *ctx, struct message *m, vtime now)
{
    if (!m->serves) {
        match_arrived(ctx, m, now);
        return;
    }
    history_add(ctx, m, now);
    post_arrived(m, now);
}

struct protocol_nodes endpoints_calls(struct node_system *sys)
{
    return (struct protocol_nodes){sys, work, move, envelope, match_sent, arrived};
}
