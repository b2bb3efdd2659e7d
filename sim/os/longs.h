/* longs.h - an element of a program's array of longs: of 4 bytes in programs compiled with nxcc --long32. */
#ifndef OS_LONGS_H
#define OS_LONGS_H
#include "node/node.h"

size_t node_long_bytes(const struct node *n);
long node_get_long(const struct node *n, const long *array, size_t i);
void node_put_long(const struct node *n, long *array, size_t i, long value);
#endif
