/* evq.h - the event queue: all that is going to happen, in the total order (doc/time.md, rule 1).
 *
 * Order: (time, address, late, ordinary, sequence). address is the number of the thing the event happens at;
 * sequence counts the events in the order they were put in, which is itself part of the order and so the same
 * in every run. A late event comes after all others of its time and address, whenever it was put in: a
 * processor goes on only after all that reaches it at that moment, so that cutting its work into slices
 * changes no order. Late events are counted by themselves. What programs send may be put in at any time
 * before it happens: such events come before the ordinary ones of their time and address, in the order of the
 * senders' numbers and then of their own.
 *
 * Where much happens at one time, what ctx and arg point to is loaded some events ahead (prefetch.h): so arg
 * may be a hint, too.
 */
#ifndef EVQ_EVQ_H
#define EVQ_EVQ_H
#include <stdbool.h>
#include "kernel/vtime.h"

struct evq;

/* What happens. now is the event's time; ctx and arg are as given. */
typedef void evq_fire(void *ctx, void *arg, vtime now);

struct evq *evq_new(void);
void evq_free(struct evq *q);

void evq_put(struct evq *q, vtime time, uint32_t address, evq_fire *fire, void *ctx, void *arg);
void evq_put_late(struct evq *q, vtime time, uint32_t address, evq_fire *fire, void *ctx, void *arg);

/* number: its low EVQ_NUMBER_BITS bits count, as no more fit into the fast queue's key, and are different for
 * what this sender has in the queue for one time and address: they would be equal only with as many as 2^22
 * messages of one sender in it. That is the rule of both engines; so of two messages that one node sends at
 * one picosecond, its 4,194,304th comes before the one sent before that. */
enum { EVQ_NUMBER_BITS = 22 };
struct evq_sender {
    uint32_t address;
    uint64_t number;
};
void evq_put_sent(struct evq *q, vtime time, uint32_t address, struct evq_sender by, evq_fire *fire,
                  void *ctx, void *arg);

/* Time of the earliest event, VT_NEVER when there is none. */
vtime evq_next(const struct evq *q);
/* Address of the earliest event, UINT32_MAX when there is none. */
uint32_t evq_next_address(const struct evq *q);
/* Would a late event at (time, address) be the earliest of all? */
bool evq_late_is_first(const struct evq *q, vtime time, uint32_t address);
/* Takes the earliest event out and lets it happen; before that, *present is its moment, and *reached that or
 * what it was, the later one. False when there is none. */
bool evq_step(struct evq *q, struct instant *present, struct instant *reached);
/* What happens so many events (at most 22) after the next, its ctx and *fire, if that is of the present time
 * and came in order; else NULL and NULL. For hints only, such as what to load into the caches: events may
 * still come in between. */
void *evq_coming(const struct evq *q, unsigned after, evq_fire **fire);
#endif
