/* race_check.h - the race checker of a machine: of nodes whose programs were built with nxcc --races. What it
 * takes for a race is in node_races.h; how the nodes tell it of what they do, in os/race_hooks.h. */
#ifndef RACES_RACE_CHECK_H
#define RACES_RACE_CHECK_H
#include "node/system.h"

struct races;
struct node_races;

struct races *races_new(void);
void races_free(struct races *r);
/* The checker of a node whose program has just been loaded, for node.races; NULL: the program was built
 * without --races. */
struct node_races *races_begin(struct races *r, struct node *n);
/* The program is gone: what was found on the node is kept. */
void races_end(struct node *n);
/* n succeeds `before`: its epochs are later. */
void races_succeed(struct node *n, const struct node *before);
#endif
