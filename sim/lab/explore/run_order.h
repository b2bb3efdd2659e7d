/* run_order.h - the order of a run: which message each receive got, and where each handler ran. Two runs of
 * one order are one trace of Mazurkiewicz (1977), whatever their times: the program has seen the same.
 *
 * Each event has a digest of itself and of all that happened before it: of its causal past (a Merkle tree, as
 * in version control). So a set of digests tells whether some run had a prefix: the digest that an event
 * would have is known before any run has it. */
#ifndef LAB_EXPLORE_RUN_ORDER_H
#define LAB_EXPLORE_RUN_ORDER_H
#include "lab/explore/event_rows.h"
#include "lab/jobs/digest.h"

/* Equal for runs of one order: from each node's receives, with sender and number of the message, and from
 * its handlers, with the number of calls that the program had begun. */
struct digest order_of_run(const struct recording *r);

struct order {
    const struct recording *recording;
    const struct event_rows *rows;
    struct digest *event; /* by rows.events */
    struct digest *past;  /* of each node's first so many events, together: event_rows.count + nodes */
};

/* The digests of the events; they refer to recording and rows. */
struct order order_of(const struct recording *r, const struct event_rows *t);
void order_free(struct order *o);

/* The digest that the receive would have with that message instead. */
struct digest order_with(const struct order *o, const struct rec_receive *v, const struct rec_message *m);
/* A digest for the handler that ran behind another event of its node instead of before it. */
struct digest order_behind(const struct order *o, const struct rec_handler *h, const struct tl_event *passed);
/* A digest for the handler at one of several moments, which orders do not tell apart. */
struct digest order_at(const struct order *o, const struct rec_handler *h, uint64_t moment);
#endif
