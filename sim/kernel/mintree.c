/* mintree.c - see mintree.h. */
#include "kernel/mintree.h"
#include "kernel/xalloc.h"
#include <stdlib.h>

void mintree_free(struct mintree *b)
{
    free(b->time);
    free(b->first);
}

/* Plays the matches from a address to the top. */
static void play(struct mintree *b, uint32_t address)
{
    for (uint32_t i = (b->room + address) / 2; i > 0; i /= 2) {
        uint32_t low = b->first[2 * i], high = b->first[2 * i + 1];
        uint32_t winner = b->time[high] < b->time[low] ? high : low;
        if (b->first[i] == winner && winner != address)
            return;
        b->first[i] = winner;
    }
}

static void make_room(struct mintree *b, uint32_t address)
{
    uint32_t had = b->room;
    for (b->room = had ? had : 2; b->room <= address;)
        b->room *= 2;
    b->time = xreallocarray(b->time, b->room, sizeof *b->time);
    b->first = xreallocarray(b->first, 2 * (size_t)b->room, sizeof *b->first);
    for (uint32_t p = had; p < b->room; p++)
        b->time[p] = VT_NEVER;
    for (uint32_t p = 0; p < b->room; p++)
        b->first[b->room + p] = p;
    for (uint32_t i = b->room - 1; i > 0; i--)
        b->first[i] =
            b->time[b->first[2 * i + 1]] < b->time[b->first[2 * i]] ? b->first[2 * i + 1] : b->first[2 * i];
}

void mintree_set(struct mintree *b, uint32_t address, vtime time)
{
    if (address >= b->room) {
        if (time == VT_NEVER)
            return;
        make_room(b, address);
    }
    b->time[address] = time;
    play(b, address);
}
