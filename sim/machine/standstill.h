/* standstill.h - nodes that live and come no further, as far as their polls and handlers show
 * (notes/livelock.h): they poll for what does not come, or stand still because handlers follow one another.
 *
 * A node is named when all of this holds. Healthy programs do not come near; doc/livelock.md says why.
 *   polls      STANDSTILL_POLLS polls of one kind in a row have found nothing, for a tenth of the node's time
 *              or longer, and such polls took half of that time
 *   handlers   STANDSTILL_HANDLERS handlers, for a tenth of the node's time or longer, took four fifths of
 *              that time, in which the program did not wait */
#ifndef MACHINE_STANDSTILL_H
#define MACHINE_STANDSTILL_H
#include "guest/backtrace.h"
#include "notes/livelock.h"

enum { STANDSTILL_POLLS = 1000, STANDSTILL_HANDLERS = 100 };

/* What a node does instead of coming further. */
struct standstill {
    const struct livelock_poll *poll;       /* the most of them; NULL: handlers */
    const struct livelock_handler *handler; /* the most of them; NULL: polls */
    const char *line;                       /* of the poll, or of the handler; NULL: not known */
    uint64_t count;
    vtime since, until; /* until: the end of the last handler, or the node's present */
    double share;       /* of this time, 0 to 1 */
    bool goes_on;       /* to the node's present */
    double others;      /* of this time: other polls */
};

/* What a node does, if it is to be named: false if not. `lines` keeps the line. */
bool standstill_of(const struct node *n, struct backtrace_lines *lines, struct standstill *s);
/* Prints the text `before` and a line without newline for each kind of standstill: nodes that do the same
 * share one, "nodes 1-5 poll: 98.1 to 98.7 % of the last 10.2 s in iprobe(7) (ring.c:42) ...". */
void standstill_print(FILE *f, const struct node_system *s, struct backtrace_lines *lines,
                      const char *before);
#endif
