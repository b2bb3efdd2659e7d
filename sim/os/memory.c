/* memory.c - see memory.h. */
#include "os/memory.h"
#include "node/system.h"

static size_t system_bytes(const struct node *n)
{
    return n->is_host ? 0 : n->sys->cfg->system_bytes;
}

size_t node_memory_all(const struct node *n)
{
    return n->is_host ? n->sys->cfg->host.memory_bytes : n->sys->cfg->memory_bytes;
}

size_t node_memory_limit(const struct node *n)
{
    return node_memory_all(n) - system_bytes(n);
}

/* What the program takes without its heap and messages. */
static size_t memory_fixed(const struct node *n)
{
    return n->guest.heap ? n->guest.image_bytes + n->sys->cfg->stack_bytes : 0; /* none: no program */
}

size_t node_memory_used(const struct node *n)
{
    return memory_fixed(n) + n->memory.heap_known + n->memory.buffered;
}

size_t node_memory_claimed(const struct node *n)
{
    return system_bytes(n) + memory_fixed(n) + n->memory.heap + n->memory.buffered_known;
}

void node_memory_changed(struct node *n)
{
    size_t used = node_memory_used(n);
    if (used > n->stats.memory_peak)
        n->stats.memory_peak = used;
}

struct memory_mark node_memory_now(const struct node *n)
{
    return (struct memory_mark){n->memory.heap, n->memory.peak_ahead};
}

void node_memory_was(struct node *n, struct memory_mark m)
{
    if (m.heap == n->memory.heap_known && m.peak <= n->stats.memory_peak)
        return;
    n->memory.heap_known = m.heap;
    if (m.peak > n->stats.memory_peak)
        n->stats.memory_peak = m.peak;
    node_memory_changed(n);
}

void node_memory_settle(struct node *n)
{
    if (n->memory.heap_moved)
        node_memory_was(n, node_memory_now(n));
    n->memory.heap_moved = false;
    if (!n->call.hands_over)
        n->memory.buffered_known = n->memory.buffered;
}

int memory_has_room(void *ctx, size_t bytes)
{
    const struct node *n = ctx;
    return memory_fixed(n) + bytes + n->memory.buffered_known <= node_memory_limit(n);
}

void memory_heap_is(void *ctx, size_t used)
{
    struct node *n = ctx;
    n->memory.heap = used;
    n->memory.heap_moved = true;
    size_t all = memory_fixed(n) + used + n->memory.buffered_known;
    if (all > n->memory.peak_ahead)
        n->memory.peak_ahead = all;
}
