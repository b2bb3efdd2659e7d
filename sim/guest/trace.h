/* trace.h - where a program is: the calls under way on its node's stack, found by the frame pointers that
 * nxcc keeps. */
#ifndef NODE_TRACE_H
#define NODE_TRACE_H
#include <stdio.h>
#include "node/node.h"

/* Are there two words at an address of the node's stack? */
bool trace_in_stack(const struct node *n, uintptr_t address);
/* The addresses that the calls from a frame upwards return to, at most `most`; how many. Safe in a signal
 * handler. */
int trace_walk(const struct node *n, uintptr_t frame, uintptr_t *returns, int most);
/* In nxc_preempt, of which it is given the frame: where in the program the poll is. */
static inline uintptr_t trace_caller(const void *frame)
{
    const uintptr_t *enter = (const uintptr_t *)*(const uintptr_t *)frame; /* nxc_enter's */
    return enter[1];
}
bool trace_in_program(const struct node *n, uintptr_t address);
/* A line "  HOW FUNCTION (FILE:LINE)", after a new line; nothing for an address outside of the program. */
void trace_print(FILE *f, const struct node *n, const char *how, uintptr_t address);
/* Such a line for each call under way in the program. */
void trace_print_calls(FILE *f, const struct node *n, uintptr_t frame);

/* The name of the library function whose call returns to an address of the program; NULL if the call does not
 * tell. */
const char *trace_called(const struct node *n, uintptr_t returns);

/* Source lines in which nodes wait. Finding one takes milliseconds, and many nodes wait in the same. */
struct trace_lines;
struct trace_lines *trace_lines_new(void);
void trace_lines_free(struct trace_lines *t);
/* "FILE:LINE" of the call in which a blocked node's program waits; NULL when it is not known. t keeps it. */
const char *trace_line(struct trace_lines *t, const struct node *n);
/* The same for an address behind a poll or call. */
const char *trace_line_at(struct trace_lines *t, const struct node *n, uintptr_t address);
#endif
