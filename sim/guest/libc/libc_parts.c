/* libc_parts.c - makes a node's part of the C library. */
#include "guest/libc/libc_parts.h"
#include "kernel/xalloc.h"
#include "node/node.h"

struct node_libc *libc_of(struct node *n)
{
    if (!n->libc)
        n->libc = xcalloc(1, sizeof *n->libc);
    return n->libc;
}
