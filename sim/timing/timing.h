/* timing.h - the delays of a run: what differs from the machine's usual timing. They are drawn (draw.h), or
 * those of a schedule (plan.h).
 *
 * Delays only make things later. So what anybody knows of how early something can happen, a lookahead or a
 * horizon, stays true.
 *
 * A run asks for the delays of a node's messages and interrupts one after another, in the order of the node's
 * program; counts belong to a node's number, and go on when another program is loaded there. */
#ifndef TIMING_TIMING_H
#define TIMING_TIMING_H
#include <stdint.h>
#include "kernel/vtime.h"
#include "timing/draw.h"
#include "timing/plan.h"

struct timing;

/* The number of the host. */
#define TIMING_HOST UINT32_MAX

/* For a run on at most so many nodes, and a host. One of draw and plan is not NULL, and
 * lasts as long. */
struct timing *timing_new(const struct draw *draw, const struct plan *plan, uint32_t nodes);
void timing_free(struct timing *t);

/* The clock of a node's processor, which usually has so many hertz: at least 1. */
uint64_t timing_clock_hz(const struct timing *t, uint32_t node, uint64_t hz);
/* The node computes slower by so many parts per million. */
uint32_t timing_speed(const struct timing *t, uint32_t node);
/* The node's program begins so much later. */
vtime timing_start(const struct timing *t, uint32_t node);
/* The next message that the node sends leaves so much later; a message to all nodes is one. */
vtime timing_next_message(struct timing *t, uint32_t node);
/* The next handler of the node becomes due so much later. */
vtime timing_next_interrupt(struct timing *t, uint32_t node);
#endif
