/* outside.h - what a run has to do with the world around it while it runs: signals, the limit of real time,
 * and a terminal that shows how far it has come. No result depends on it, but for where a run ends that is
 * ended. */
#ifndef MACHINE_OUTSIDE_H
#define MACHINE_OUTSIDE_H
#include <signal.h>
#include "machine/machine.h"

/* While the run lasts, its signals are blocked, and looked at now and then: so the nodes' output is not lost,
 * and the user is told where each node is. */
void outside_begin(struct machine *m);
/* Looks at all of that: ends the run, or answers. m is a struct machine: for schedule.look. */
void outside_look(void *m);
void outside_end(struct machine *m);
/* Takes a signal that waits and is to end the run, and notes the first in m->signal. 0: none waits. Safe in a
 * handler of a signal. */
int outside_take_ending(struct machine *m);
#endif
