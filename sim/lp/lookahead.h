/* lookahead.h - what may reach a node, and until when it may compute.
 *
 *     horizon    nothing reaches the node before: the earliest of the queue's events, the other nodes' poll
 *                times and the tasks' lower bounds, and what a message takes at least from there
 *                (protocol_horizon)
 *     deadline   an interruptible program computes up to its horizon, others to the limit of virtual time */
#ifndef LP_LOOKAHEAD_H
#define LP_LOOKAHEAD_H
#include "lp/lp.h"

/* Can nothing reach the node until t, t included? */
bool lp_is_alone(const struct lp *lp, vtime t);
/* Until when the program may compute from now on; notes whether it is interruptible. */
vtime lp_deadline(struct lp *lp);
/* A program paused at a poll needs nothing, and sends nothing, before this time; 0: unknown. */
vtime lp_lookahead(const struct lp *lp);
#endif
