/* debugger.h - tells a debugger which programs are loaded, and where, so that it knows their functions, lines
 * and variables.
 *
 * Node programs are loaded by our own loader (image.h), of which debuggers know nothing. But each process has
 * a list of its shared libraries for debuggers, which the dynamic loader keeps (<link.h>: struct r_debug).
 * The programs are listed there, as libraries in a namespace of their own, each node's at its own address:
 *
 *     the loader's r_debug --r_next--> ours --r_map--> node 0's program --> node 1's --> ...
 *         libc.so.6, libm.so.6 ...     l_addr, l_name, l_ld of each
 *
 * Whoever changes the list calls the function r_brk, which does nothing: there debuggers have a breakpoint,
 * and read the list. */
#ifndef GUEST_DEBUGGER_H
#define GUEST_DEBUGGER_H
#include <stdbool.h>
#include "node/node.h"

/* The list of the machine's programs. */
struct debugger;

/* Does a debugger (gdb, lldb, rr) trace this process? */
bool debugger_is_attached(void);

/* NULL: this C library keeps no such list. There may be one at a time. */
struct debugger *debugger_new(void);
void debugger_free(struct debugger *d);
/* A program has been loaded on n; its file stays where it is. The debugger learns of it by
 * debugger_tell(). */
void debugger_add(struct debugger *d, const struct node *n);
/* n's program is going to be unloaded; the same. */
void debugger_remove(struct debugger *d, const struct node *n);
/* Has the debugger read the list, if it has changed. */
void debugger_tell(struct debugger *d);
#endif
