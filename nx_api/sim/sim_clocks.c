/* sim_clocks.c - the clocks of a simulated machine, its shape, and what a program may do with its
 * processor. */
#include "lp/clock.h"
#include "nx_api/calls/call.h"

void nx_rectangle(const struct node *n, long *rows, long *columns)
{
    const struct topo *t = &n->sys->topo;
    *rows = t->rows ? t->rows : 1;
    *columns = t->rows ? t->columns : n->sys->count;
}

/* --- clocks --- */

static vtime read_clock(struct node *n)
{
    node_spend(n, n->sys->cfg->clock_call_ps);
    return node_now(n);
}

static vtime clock_call(const char *call)
{
    struct node *n = node_self();
    node_enter(n, call);
    vtime now = read_clock(n);
    nx_plain(n, 0);
    return now;
}

unsigned long node_mclock(void)
{
    return (unsigned long)(clock_call("mclock") / VT_MILLISECOND);
}

unsigned long node__mclock(void)
{
    return node_mclock();
}

double node_dclock(void)
{
    return vt_seconds(clock_call("dclock"));
}

double node__dclock(void)
{
    return node_dclock();
}

uint64_t nx_ticks(struct node *n)
{
    unsigned __int128 product = (unsigned __int128)read_clock(n) * n->sys->cfg->hwclock_hz;
    return (uint64_t)(product / VT_SECOND);
}

/* --- the processor --- */

long nxs_flick(void)
{
    struct node *n = node_self();
    nx_spend_call(n);
    nx_spend_kernel(n);
    nx_found_nothing(n, NULL);
    return 0;
}

/* The light on the node's board shows nowhere. */
long nxs_led(word state)
{
    struct node *n = node_self();
    (void)state;
    node_spend(n, n->sys->cfg->clock_call_ps);
    nx_spend_kernel(n);
    return 0;
}

long nxs_masktrap(word state)
{
    struct node *n = node_self();
    bool before;
    node_spend(n, n->sys->cfg->clock_call_ps);
    nx_spend_kernel(n);
    before = handlers_mask(n, state != 0);
    if (before && !n->handlers.masked)
        handlers_open(n);
    node_order(n);
    for (vtime now = node_now(n); handlers_run_held(n, now);)
        node_order(n);
    return before;
}
