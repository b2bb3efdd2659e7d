/* whereabouts.h - the places of the programs of a machine that has stopped, or stands still for a moment. */
#ifndef MACHINE_WHEREABOUTS_H
#define MACHINE_WHEREABOUTS_H
#include "node/system.h"

/* Returns the line `what`, and below it where the host program and each node are: the call in which the
 * program waits, since when, and the source line if it is known. A line for each node; of many nodes, those
 * in the same state share one. For the user; malloc'd. */
char *whereabouts(const struct node_system *s, const char *what);
/* The same, with one line for all nodes in the same state, however few. */
char *whereabouts_grouped(const struct node_system *s, const char *what);
/* The line of one node: "node 3: crecv(7) since 0.000412300 s (ring.c:17)". Malloc'd. */
char *whereabouts_of(const struct node *n);
#endif
