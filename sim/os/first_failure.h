/* first_failure.h - the reason for which the machine stops before its programs have ended. */
#ifndef OS_FIRST_FAILURE_H
#define OS_FIRST_FAILURE_H
#include "node/system.h"

/* Records the first failure (printf-like), and stops the machine at a moment, because of `why`. */
void node_system_fail(struct node_system *sys, enum stop why, struct instant at, const char *fmt, ...)
    __attribute__((format(printf, 4, 5)));
/* Nothing is left to happen but what comes after the limit of virtual time: stops the machine there, unless
 * sys->pauses() has set another limit. */
void node_system_end_at_limit(struct node_system *sys);
#endif
