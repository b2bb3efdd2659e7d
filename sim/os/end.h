/* end.h - the ends of programs: by themselves, by others, or because the machine stops. */
#ifndef OS_END_H
#define OS_END_H
#include "node/system.h"

/* Ends the program from inside one of its calls; never returns. */
_Noreturn void node_end_here(struct node *n, enum node_end how, int code);
/* The program is in a call that waits for other programs' ends, and is woken whenever one ends; or is not any
 * more. */
void node_awaits_end(struct node *n, bool awaits);
/* Such a call has reported the end of n's program. */
void node_notice_end(struct node *n);
/* Another program ends the node's, or the machine stops, at a moment: what the program has done after it has
 * not happened. */
void node_stop(struct node *n, struct instant at);
/* Ends another node's program, at the time of the caller. */
void node_end_other(struct node *n, struct node *victim);
/* The program has crashed at its clock's time, which is committed. */
void node_end_crashed(struct node *n);
/* Has its program ended by exit with a status that tells of an error? (What main of an old NX program returns
 * tells of none: main_tells.) */
static inline bool node_exited_badly(const struct node *n)
{
    return n->end.how == NODE_EXITED && n->end.exit_code != 0;
}
/* The first node that has; NULL: none. */
const struct node *node_bad_exit(const struct node_system *s);
/* The machine has stopped at a moment, after which nothing has happened: the node's books are those of then.
 * at_a_time: stopped by a moment of virtual time; a node that computes may have been ahead of it. */
void node_settle(struct node *n, struct instant end, bool at_a_time);
#endif
