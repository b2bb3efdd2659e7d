/* overdue.h - the end of programs that do not come back to the system. A run looks at signals and host time
 * (outside.h) when a program calls or polls; a loop in which the compiler put no poll, such as one in
 * assembler, never does. Such a program is ended where it is, a second after the run was to end. A second
 * signal that comes so late ends the process at once, whatever it does. */
#ifndef MACHINE_OVERDUE_H
#define MACHINE_OVERDUE_H
#include <pthread.h>
#include "machine/machine.h"

/* On the thread that runs the machine, which has a guard (crash.h). */
void overdue_begin(struct machine *m);
void overdue_end(void);
/* The run is to end from now on. Safe in a handler of a signal. */
void overdue_from_now(void);
/* Another thread of the machine is waited for: its program is ended if the run should have ended by now. */
void overdue_hurry(pthread_t thread);
#endif
