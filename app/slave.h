/* slave.h - a node that computes subcubes for a host. */
#ifndef SLAVE_H
#define SLAVE_H
#include "options.h"

/* Allocate the buffers. */
void slave_prepare(const struct options *o);

/* Serve `host`, then whichever host the node is dealt to, until the program ends. NOBODY: wait for an order
 * at once. */
void slave_run(int host);

/* Seconds the slave has waited for messages. */
extern double slave_idle_s;

#endif
