/* block.h - a node that waits in a call: its program rests, and its clock stands still until it resumes. */
#ifndef LP_BLOCK_H
#define LP_BLOCK_H
#include "lp/lp.h"

/* The program begins a call that may wait: it has not been blocked in it. */
static inline void lp_begin_wait(struct lp *lp)
{
    lp->blocked_since = VT_NEVER;
}
/* The program, in a call, waits from now on. */
void lp_block(struct lp *lp, vtime now);
/* At a later moment: if a handler is due, or what the program waits for is there, the wait ends, and the
 * clock advances to now. False: the node still waits, and is unchanged; may be called repeatedly. */
bool lp_unblock(struct lp *lp, vtime now);
/* The program has come no further than time t, when it is ended: its clock, or its wait, ends then. True: it
 * was computing. */
bool lp_end_at(struct lp *lp, vtime t);
#endif
