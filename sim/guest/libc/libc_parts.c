/* libc_parts.c - makes a node's part of the C library. */
#include "guest/libc/libc_parts.h"
#include "kernel/xalloc.h"
#include "node/node.h"

struct node_libc *libc_of(struct node *n)
{
    if (!n->guest.libc)
        n->guest.libc = xcalloc(1, sizeof *n->guest.libc);
    return n->guest.libc;
}
