/* fail.h - errors that end the run. node_fail() is nx_api/contract/backend.h's. */
#ifndef OS_FAIL_H
#define OS_FAIL_H
#include "node/node.h"

/* An error in a library of the program: message naming call, node, time; ends the process with status 1.
 * frame is that of the library's function which the program called, NULL unknown. */
_Noreturn void node_fail_in(struct node *n, const void *frame, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
#endif
