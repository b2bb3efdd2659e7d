/* shape.c - the shape of the machine, and hwclock. */
#include "nx_api/calls/shape.h"
#include "nx_api/calls/call.h"

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
    long high, wide;
    if (!rows || !columns)
        return node_error(n, EQPBUF, "rows or columns is a null pointer");
    nx_rectangle(n, &high, &wide);
    node_put_long(n, rows, 0, high);
    node_put_long(n, columns, 0, wide);
    return 0;
}

long nxs_mypart(long *rows, long *columns)
{
    return nxs_nx_app_rect(rows, columns);
}

long nxs_hwclock(esize_t *ticks)
{
    struct node *n = node_self();
    if (!ticks)
        return node_error(n, EQPBUF, "the place for the count is a null pointer");
    uint64_t count = nx_ticks(n);
    node_put_long(n, &ticks->slow, 0, (long)(uint32_t)count);
    node_put_long(n, &ticks->slow, 1, (long)(count >> 32));
    return 0;
}
