/* mintree.h - the least of many times, each at a address that has one or none; of equal times that at the
 * lowest address. To set one takes as many steps as the number of addresses has bits, to find the least takes
 * none. */
#ifndef KERNEL_MINTREE_H
#define KERNEL_MINTREE_H
#include <stdint.h>
#include "kernel/vtime.h"

/* A tournament: first[1] is the address of the least time of all, first[i] that of first[2 i] and first[2 i +
 * 1]; the addresses themselves are the last half. All zero: no address has a time. */
struct mintree {
    vtime *time; /* by address; VT_NEVER: none */
    uint32_t *first;
    uint32_t room; /* addresses, a power of 2, or 0 */
};

void mintree_free(struct mintree *b);
/* VT_NEVER: none. */
void mintree_set(struct mintree *b, uint32_t address, vtime time);
/* VT_NEVER: no address has one. */
static inline vtime mintree_least(const struct mintree *b)
{
    return b->room ? b->time[b->first[1]] : VT_NEVER;
}
/* Where the least is, if there is one. */
static inline uint32_t mintree_address(const struct mintree *b)
{
    return b->first[1];
}
#endif
