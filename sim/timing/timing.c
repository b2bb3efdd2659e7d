/* timing.c - see timing.h. */
#include "timing/timing.h"
#include <assert.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

/* The delays of a plan, one after another. */
struct planned {
    const struct plan_item *next, *end;
};

struct timed_node {
    struct draw_node drawn; /* draw NULL: nothing is */
    struct planned message, interrupt;
    uint64_t messages, interrupts; /* so far */
    uint32_t speed_ppm;
    vtime start;
};

struct timing {
    uint32_t nodes;
    struct timed_node node[]; /* and the host's */
};

static void draw_for(struct timed_node *n)
{
    n->speed_ppm = draw_speed(&n->drawn);
    n->start = draw_start(&n->drawn);
}

static struct planned planned_of(const struct plan_list *l)
{
    return (struct planned){l->item, l->item + l->count};
}

static void plan_for(struct timed_node *n, const struct plan_node *p)
{
    n->message = planned_of(&p->messages);
    n->interrupt = planned_of(&p->interrupts);
    n->speed_ppm = p->speed_ppm;
    n->start = p->start;
}

struct timing *timing_new(const struct draw *draw, const struct plan *plan, uint32_t nodes)
{
    assert(!draw != !plan && (!plan || plan->nodes == nodes));
    struct timing *t = xcalloc(1, sizeof *t + (nodes + 1) * sizeof *t->node);
    struct draw_node *drawn = draw ? draw_nodes(draw, nodes + 1) : NULL;
    t->nodes = nodes;
    for (uint32_t i = 0; i <= nodes; i++) {
        if (draw) {
            t->node[i].drawn = drawn[i];
            draw_for(&t->node[i]);
        } else {
            plan_for(&t->node[i], &plan->node[i]);
        }
    }
    free(drawn);
    return t;
}

void timing_free(struct timing *t)
{
    free(t);
}

static struct timed_node *node_of(const struct timing *t, uint32_t node)
{
    assert(node < t->nodes || node == TIMING_HOST);
    return (struct timed_node *)&t->node[node == TIMING_HOST ? t->nodes : node];
}

uint64_t timing_clock_hz(const struct timing *t, uint32_t node, uint64_t hz)
{
    enum { MILLION = 1000000 };
    uint64_t slower = MILLION + (uint64_t)node_of(t, node)->speed_ppm;
    uint64_t clock = (uint64_t)((unsigned __int128)hz * MILLION / slower);
    return clock ? clock : 1;
}

uint32_t timing_speed(const struct timing *t, uint32_t node)
{
    return node_of(t, node)->speed_ppm;
}

vtime timing_start(const struct timing *t, uint32_t node)
{
    return node_of(t, node)->start;
}

/* The plan's delay of the k-th; items ascend, and so does k. */
static vtime take_planned(struct planned *p, uint64_t k)
{
    return p->next != p->end && p->next->k == k ? p->next++->later : 0;
}

vtime timing_next_message(struct timing *t, uint32_t node)
{
    struct timed_node *n = node_of(t, node);
    uint64_t k = n->messages++;
    return n->drawn.draw ? draw_message(&n->drawn, k) : take_planned(&n->message, k);
}

vtime timing_next_interrupt(struct timing *t, uint32_t node)
{
    struct timed_node *n = node_of(t, node);
    uint64_t k = n->interrupts++;
    return n->drawn.draw ? draw_interrupt(&n->drawn, k) : take_planned(&n->interrupt, k);
}
