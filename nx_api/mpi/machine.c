/* machine.c - what a program may know of its machine, its clocks, and the processor. Time is real: seconds since the
 * program began. */
#include <mpi.h>
#include <sched.h>
#include "nx_api/calls/call.h"
#include "nx_api/mpi/mailbox.h"

unsigned long node_mclock(void) NX_EXPORT("mclock");
unsigned long node__mclock(void) NX_EXPORT("_mclock");
double node_dclock(void) NX_EXPORT("dclock");
double node__dclock(void) NX_EXPORT("_dclock");

long nx_dimension(const struct node *n)
{
    long d = 0;
    while ((UINT32_C(1) << d) < n->sys->count)
        d++;
    return d;
}

/* The squarest rectangle, wider than high. */
long nxs_nx_app_rect(long *rows, long *columns)
{
    struct node *n = node_self();
    int sides[2] = {0, 0};
    if (!rows || !columns)
        return node_error(n, EQPBUF, "rows or columns is a null pointer");
    MPI_Dims_create((int)n->sys->count, 2, sides);
    node_put_long(n, rows, 0, sides[1]);
    node_put_long(n, columns, 0, sides[0]);
    return 0;
}

long nxs_mypart(long *rows, long *columns)
{
    return nxs_nx_app_rect(rows, columns);
}

unsigned long node_mclock(void)
{
    return (unsigned long)(node_seconds() * 1e3);
}

unsigned long node__mclock(void)
{
    return node_mclock();
}

double node_dclock(void)
{
    return node_seconds();
}

double node__dclock(void)
{
    return node_seconds();
}

long nxs_hwclock(esize_t *ticks)
{
    enum { HZ = 10000000 };
    struct node *n = node_self();
    if (!ticks)
        return node_error(n, EQPBUF, "the place for the count is a null pointer");
    uint64_t count = (uint64_t)(node_seconds() * HZ);
    node_put_long(n, &ticks->slow, 0, (long)(uint32_t)count);
    node_put_long(n, &ticks->slow, 1, (long)(count >> 32));
    return 0;
}

long nxs_flick(void)
{
    sched_yield();
    return 0;
}

/* A light that nobody sees. */
long nxs_led(word state)
{
    (void)state;
    return 0;
}

/* The handlers that were held back run before the call returns: node_leave. */
long nxs_masktrap(word state)
{
    struct node *n = node_self();
    long before = n->masked;
    n->masked = state != 0;
    return before;
}
