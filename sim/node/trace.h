/* trace.h - where a program is: the calls under way on its node's stack, found by the frame pointers that nxcc keeps. */
#ifndef NODE_TRACE_H
#define NODE_TRACE_H
#include <stdio.h>
#include "node/node.h"

/* Are there two words at an address of the node's stack? */
bool trace_in_stack(const struct node *n, uintptr_t address);
/* The addresses that the calls from a frame upwards return to, at most `most`; how many. Safe in a signal handler. */
int trace_walk(const struct node *n, uintptr_t frame, uintptr_t *returns, int most);
bool trace_in_program(const struct node *n, uintptr_t address);
/* A line "  HOW FUNCTION (FILE:LINE)", after a new line; nothing for an address outside of the program. */
void trace_print(FILE *f, const struct node *n, const char *how, uintptr_t address);
/* Such a line for each call under way in the program. */
void trace_print_calls(FILE *f, const struct node *n, uintptr_t frame);

/* Source lines in which nodes wait. Finding one takes milliseconds, and many nodes wait in the same. */
struct trace_lines;
struct trace_lines *trace_lines_new(void);
void trace_lines_free(struct trace_lines *t);
/* "FILE:LINE" of the call in which a blocked node's program waits; NULL when it is not known. t keeps it. */
const char *trace_line(struct trace_lines *t, const struct node *n);
#endif
