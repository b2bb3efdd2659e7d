/* fail.h - errors: of an NX call, which its program may look at; and those that end the run. */
#ifndef OS_FAIL_H
#define OS_FAIL_H
#include "node/system.h"

/* Records the first failure (printf-like), and stops the machine at a moment, because of `why`. */
void node_system_fail(struct node_system *sys, enum stop why, struct instant at, const char *fmt, ...)
    __attribute__((format(printf, 4, 5)));
/* Nothing is left to happen but what comes after the limit of virtual time: stops the machine there. */
void node_system_end_at_limit(struct node_system *sys);

/* An error in an NX call: sets n->error, and is -1 so that a function can return it. */
long node_error(struct node *n, int code, const char *fmt, ...) __attribute__((format(printf, 3, 4)));
/* An error in a plain NX call: message naming call, node, time; ends the process (NX rule) with status 1. */
_Noreturn void node_fail(struct node *n, const char *fmt, ...) __attribute__((format(printf, 2, 3)));
/* The same from inside a library of the program: frame is that of its function which the program called, NULL unknown. */
_Noreturn void node_fail_in(struct node *n, const void *frame, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
#endif
