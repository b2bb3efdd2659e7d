/* machine.c - what a program may know of its machine, its clocks, and the processor. */
#include "nx_api/sim/call.h"
#include "lp/clock.h"
#include "node/self.h"
#include "os/fail.h"
#include "os/front.h"
#include "os/gate.h"
#include "os/longs.h"

/* --- shape --- */

long nx_dimension(const struct node *n)
{
    long d = 0;
    while ((UINT32_C(1) << d) < n->sys->count)
        d++;
    return d;
}

long nxs_nx_app_rect(long *rows, long *columns)
{
    struct node *n = node_self();
    const struct topo *t = &n->sys->topo;
    if (!rows || !columns)
        return node_error(n, EQPBUF, "rows or columns is a null pointer");
    node_put_long(n, rows, 0, t->rows ? t->rows : 1);
    node_put_long(n, columns, 0, t->rows ? t->columns : n->sys->count);
    return 0;
}

long nxs_mypart(long *rows, long *columns)
{
    return nxs_nx_app_rect(rows, columns);
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

long nxs_hwclock(esize_t *ticks)
{
    struct node *n = node_self();
    if (!ticks)
        return node_error(n, EQPBUF, "the place for the count is a null pointer");
    unsigned __int128 product = (unsigned __int128)read_clock(n) * n->sys->cfg->hwclock_hz;
    uint64_t count = (uint64_t)(product / VT_SECOND);
    node_put_long(n, &ticks->slow, 0, (long)(uint32_t)count);
    node_put_long(n, &ticks->slow, 1, (long)(count >> 32));
    return 0;
}

/* --- the processor --- */

long nxs_flick(void)
{
    struct node *n = node_self();
    nx_spend_call(n);
    nx_spend_kernel(n);
    return 0;
}

/* A light that nobody sees. */
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
    if (before && !n->masked)
        handlers_open(n);
    node_order(n);
    for (vtime now = node_now(n); handlers_run_held(n, now);)
        node_order(n);
    return before;
}
