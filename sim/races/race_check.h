/* race_check.h - the race checker of a machine: of nodes whose programs were built with nxcc --races. What it
 * takes for a race is in node_races.h; it observes what the nodes do (os/observer.h). */
#ifndef RACES_RACE_CHECK_H
#define RACES_RACE_CHECK_H
#include "node/system.h"

struct races;

struct races *races_new(void);
void races_free(struct races *r);
/* Begins to check a node whose program has just been loaded, if it was built with --races. */
void races_begin(struct races *r, struct node *n);
/* The program is gone: what was found on the node, if it was checked, is kept. */
void races_end(struct node *n);
/* The run is over; handlers that run yet will not end. */
void races_over(struct races *r);
/* n succeeds `before`: its epochs are later. */
void races_succeed(struct node *n, const struct node *before);
/* The host has loaded n, which is about to start. */
void races_loaded(struct node *n, struct node *host);
#endif
