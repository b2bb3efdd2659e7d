/* draw.c - see draw.h. */
#include "timing/draw.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

/* What is drawn: numbers for different purposes are independent. */
enum purpose { SPEED, START, MESSAGE, INTERRUPT, PRIORITY, POINT };

struct draw draw_usual(void)
{
    return (struct draw){.method = DRAW_RANDOM,
                         .depth = 3,
                         .length = 1000,
                         .messages = 100 * VT_MICROSECOND,
                         .interrupts = 50 * VT_MICROSECOND,
                         .start = VT_MILLISECOND,
                         .speed_ppm = 20000};
}

/* --- numbers: SplitMix64 as a function of a counter (Steele, Lea & Flood, OOPSLA 2014) --- */

static uint64_t mix(uint64_t x)
{
    x += UINT64_C(0x9e3779b97f4a7c15);
    x = (x ^ (x >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ (x >> 27)) * UINT64_C(0x94d049bb133111eb);
    return x ^ (x >> 31);
}

static uint64_t number(const struct draw *d, enum purpose what, uint32_t node, uint64_t k)
{
    return mix(mix(mix(mix(d->seed) ^ (uint64_t)what) ^ node) ^ k);
}

/* 0 to most, from a random number x. */
static uint64_t up_to(uint64_t x, uint64_t most)
{
    return (uint64_t)((unsigned __int128)x * ((unsigned __int128)most + 1) >> 64);
}

/* --- method random --- */

static uint64_t draw_any(uint64_t x, uint64_t bound)
{
    enum { TIE_PS = 1000 };
    uint64_t kind = x % 8, value = mix(x);
    if (kind < 4)
        return 0;
    return up_to(value, kind == 4 && bound > TIE_PS ? TIE_PS : bound);
}

/* --- method pct --- */

struct priority {
    uint64_t value;
    uint32_t node;
};

static int from_highest(const void *a, const void *b)
{
    const struct priority *x = a, *y = b;
    return x->value != y->value ? (x->value < y->value) - (x->value > y->value)
                                : (x->node > y->node) - (x->node < y->node);
}

static void draw_priorities(const struct draw *d, uint32_t nodes, struct draw_node *node)
{
    struct priority *list = xcalloc(nodes, sizeof *list);
    for (uint32_t i = 0; i < nodes; i++)
        list[i] = (struct priority){number(d, PRIORITY, i, 0), i};
    qsort(list, nodes, sizeof *list, from_highest);
    for (uint32_t i = 0; i < nodes; i++)
        node[list[i].node].behind = i;
    free(list);
}

/* The last of the points that the node has passed when it comes to its k-th message or interrupt, counted
 * from 1; 0: none. */
static uint32_t point_passed(const struct draw_node *n, uint64_t k)
{
    const struct draw *d = n->draw;
    uint64_t each = d->length / n->nodes + (d->length % n->nodes > 0);
    uint32_t last = 0;
    for (uint32_t i = 1; i < d->depth; i++)
        if (up_to(number(d, POINT, i, 0), n->nodes - 1) == n->node &&
            up_to(number(d, POINT, i, 1), each - 1) <= k)
            last = i;
    return last;
}

static uint64_t part(uint64_t bound, uint64_t of, uint64_t all)
{
    return (uint64_t)((unsigned __int128)bound * of / all);
}

/* 0 to half of the bound. */
static uint64_t by_priority(const struct draw_node *n, uint64_t bound)
{
    return n->nodes > 1 ? part(bound, n->behind, 2 * (uint64_t)(n->nodes - 1)) : 0;
}

/* Half of the bound to all of it. */
static uint64_t by_point(const struct draw_node *n, uint64_t bound, uint64_t k)
{
    uint32_t point = point_passed(n, k), points = n->draw->depth - 1;
    return point ? part(bound, points + point, 2 * (uint64_t)points) : by_priority(n, bound);
}

/* --- */

struct draw_node *draw_nodes(const struct draw *d, uint32_t nodes)
{
    struct draw_node *node = xcalloc(nodes, sizeof *node);
    for (uint32_t i = 0; i < nodes; i++)
        node[i] = (struct draw_node){d, nodes, i, 0};
    if (d->method == DRAW_PCT)
        draw_priorities(d, nodes, node);
    return node;
}

static uint64_t draw_once(const struct draw_node *n, enum purpose what, uint64_t bound)
{
    if (n->draw->method == DRAW_PCT)
        return by_priority(n, bound);
    return draw_any(number(n->draw, what, n->node, 0), bound);
}

static uint64_t draw_kth(const struct draw_node *n, enum purpose what, uint64_t bound, uint64_t k)
{
    if (n->draw->method == DRAW_PCT)
        return by_point(n, bound, k);
    return draw_any(number(n->draw, what, n->node, k), bound);
}

uint32_t draw_speed(const struct draw_node *n)
{
    return (uint32_t)draw_once(n, SPEED, n->draw->speed_ppm);
}

vtime draw_start(const struct draw_node *n)
{
    return draw_once(n, START, n->draw->start);
}

vtime draw_message(const struct draw_node *n, uint64_t k)
{
    return draw_kth(n, MESSAGE, n->draw->messages, k);
}

vtime draw_interrupt(const struct draw_node *n, uint64_t k)
{
    return draw_kth(n, INTERRUPT, n->draw->interrupts, k);
}
