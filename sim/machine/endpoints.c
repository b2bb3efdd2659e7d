/* endpoints.c - the inhabitants of the network's addresses: the answers to net/endpoint.h, whose `ends` is
 * the node_system. An address is a node's, a service's, or the host's (topo.h). m->serves tells the
 * messages between a node and a service, in both directions. */
#include "net/endpoint.h"
#include "cfs/cfs.h"
#include "cfs/post.h"
#include "machine/history.h"
#include "os/charge.h"
#include "os/match.h"

static bool is_service(const struct node_system *sys, uint32_t address)
{
    return address >= sys->topo.positions && !topo_is_host(&sys->topo, address);
}

vtime endpoint_work(void *ends, uint32_t address, enum protocol_task task, vtime at, vtime t)
{
    struct node_system *sys = ends;
    if (is_service(sys, address))
        return cfs_work(sys->cfs, address, at, t);
    if (sys->cfg->entry_ps)
        t += charge_entry(sys, address, at);
    return node_work(sys, address, task, at, t);
}

/* No program runs on a service's processor, so moving bytes is work like any other. */
void endpoint_pio(void *ends, uint32_t address, enum protocol_task task, vtime at, vtime t)
{
    struct node_system *sys = ends;
    if (is_service(sys, address))
        cfs_work(sys->cfs, address, at, t);
    else
        node_move(sys, address, task, at, t);
}

bool endpoint_envelope(void *ends, struct message *m, vtime now)
{
    return m->serves ? post_envelope(m, now) : match_envelope(ends, m, now);
}

void endpoint_sent(void *ends, struct message *m, vtime now)
{
    match_sent(ends, m, now);
}

void endpoint_arrived(void *ends, struct message *m, vtime now)
{
    history_add(ends, m, now);
    if (m->serves)
        post_arrived(m, now);
    else
        match_arrived(ends, m);
}
