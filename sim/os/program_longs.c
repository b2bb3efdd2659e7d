/* program_longs.c - an element of a program's array of longs: nx_api/contract/backend.h. */
#include "node/node.h"
#include "nx_api/contract/backend.h"
#include "nx_api/contract/program_image.h"

size_t node_long_bytes(const struct node *n)
{
    return (size_t)n->guest.image->long_bytes;
}

long node_get_long(const struct node *n, const long *array, size_t i)
{
    return node_long_bytes(n) == sizeof(int32_t) ? ((const int32_t *)array)[i] : array[i];
}

void node_put_long(const struct node *n, long *array, size_t i, long value)
{
    if (node_long_bytes(n) == sizeof(int32_t))
        ((int32_t *)array)[i] = (int32_t)value;
    else
        array[i] = value;
}
