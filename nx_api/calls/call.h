/* call.h - what the files that serve NX's calls share, those of the back ends, too.
 *
 * A call has one implementation, nxs_NAME, and two entry points generated from calls.def: node_NAME and
 * node__NAME, which programs reach as NAME and _NAME. An entry point begins the call, runs the implementation
 * on the calling node's stack, and leaves. The implementation spends system time and returns the call's
 * result, 0 or more, or node_error()'s -1. Then NAME ends the process with a message that names call and
 * node, and _NAME returns -1 with errno set.
 */
#ifndef CALLS_CALL_H
#define CALLS_CALL_H
#include "backend_node.h"
#include "nx_api/include/estat.h"
#include "nx_api/include/host.h"
#include "nx_api/include/nx.h"

enum { ALL_NODES = -1, ANY = -1 };

#define NX_CALL(name, parameters, arguments) long nxs_##name parameters;
#define NX_VALUE(name, expression)
#define NX_OTHER(name)
#include "nx_api/contract/calls.def"
#undef NX_CALL
#undef NX_VALUE
#undef NX_OTHER

/* How an entry point ends, for those that are written by hand: it leaves, given the call's result, or -1.
 * NAME ends by nx_plain, which does not return after an error; _NAME ends by nx_returning. */
nx_end nx_plain, nx_returning;

/* Checks that several calls make: 0, or -1 with the error. */
long nx_check_node(struct node *n, long node);
long nx_check_victim(struct node *n, word node); /* a node, or -1: all */
long nx_check_buffer(struct node *n, const void *buf, long len);

#endif
