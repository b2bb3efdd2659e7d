/* whereabouts.h - where the programs of a machine that has stopped are. */
#ifndef MACHINE_WHEREABOUTS_H
#define MACHINE_WHEREABOUTS_H
#include "node/system.h"

/* Returns the line `what`, and below it a line for the host program and for each node: the call in which the
 * program waits, since when, and the source line if it is known. For the user; malloc'd. */
char *whereabouts(const struct node_system *s, const char *what);
#endif
