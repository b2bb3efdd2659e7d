/* verdict.h - the verdict of a run: it ended well, with a failure, or in a deadlock. */
#ifndef MACHINE_VERDICT_H
#define MACHINE_VERDICT_H
#include "machine/machine.h"

/* Sets m->outcome and m->message, when no program of m runs any more. */
void verdict(struct machine *m);
/* Notes where a program has ended by exit with an error, and tells the user if others go on. */
void verdict_exited(struct node *n);
#endif
