/* mpi_clocks.c - the clocks, which show seconds since the program began; the shape of the machine; the
 * processor. */
#include <mpi.h>
#include <sched.h>
#include "nx_api/calls/call.h"
#include "nx_api/mpi/mpi_node.h"

unsigned long node_mclock(void) NX_EXPORT("mclock");
unsigned long node__mclock(void) NX_EXPORT("_mclock");
double node_dclock(void) NX_EXPORT("dclock");
double node__dclock(void) NX_EXPORT("_dclock");

/* The squarest rectangle, wider than high. */
void nx_rectangle(const struct node *n, long *rows, long *columns)
{
    int sides[2] = {0, 0};
    MPI_Dims_create((int)n->sys->count, 2, sides);
    *rows = sides[1];
    *columns = sides[0];
}

unsigned long node_mclock(void)
{
    return (unsigned long)(mpi_seconds() * 1e3);
}

unsigned long node__mclock(void)
{
    return node_mclock();
}

double node_dclock(void)
{
    return mpi_seconds();
}

double node__dclock(void)
{
    return mpi_seconds();
}

uint64_t nx_ticks(struct node *n)
{
    enum { HZ = 10000000 };
    (void)n;
    return (uint64_t)(mpi_seconds() * HZ);
}

long nxs_flick(void)
{
    sched_yield();
    return 0;
}

/* There is no light. */
long nxs_led(word state)
{
    (void)state;
    return 0;
}

/* Handlers that were held back run before the call returns, in node_leave. */
long nxs_masktrap(word state)
{
    struct node *n = node_self();
    long before = n->masked;
    n->masked = state != 0;
    return before;
}
