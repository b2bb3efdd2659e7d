/* trace.h - where a program is: the calls under way on its node's stack, found by the frame pointers that
 * nxcc keeps. */
#ifndef GUEST_TRACE_H
#define GUEST_TRACE_H
#include <stdio.h>
#include "node/node.h"

/* Does an address, and the next word, lie in a stack of the node's program? */
bool trace_in_stack(const struct node *n, uintptr_t address);
/* Writes the return addresses of the calls from a frame upwards, at most `most`, and returns how many. Safe
 * in a signal handler. */
int trace_walk(const struct node *n, uintptr_t frame, uintptr_t *returns, int most);
/* Where in the program the poll is, if `frame` is that of nxc_preempt. */
static inline uintptr_t trace_caller(const void *frame)
{
    const uintptr_t *enter = (const uintptr_t *)*(const uintptr_t *)frame; /* the frame of nxc_enter */
    return enter[1];
}
bool trace_in_program(const struct node *n, uintptr_t address);
/* Prints a newline and "  HOW FUNCTION (FILE:LINE)"; nothing for an address outside of the program. */
void trace_print(FILE *f, const struct node *n, const char *how, uintptr_t address);
/* Prints such a line for each call under way in the program, from a frame upwards. */
void trace_print_calls(FILE *f, const struct node *n, uintptr_t frame);

/* The name of the library function whose call returns to an address of the program; NULL if the call's
 * instruction does not tell. */
const char *trace_called(const struct node *n, uintptr_t returns);

/* The source lines in which nodes wait, each found once: finding one takes milliseconds of host time, and
 * many nodes wait in one line. */
struct trace_lines;
struct trace_lines *trace_lines_new(void);
void trace_lines_free(struct trace_lines *t);
/* "FILE:LINE" of the call in which a blocked node's program waits; NULL if it is not known. t keeps the
 * text. */
const char *trace_line(struct trace_lines *t, const struct node *n);
/* The same of any program that does not run at the moment, wherever it has switched away. */
const char *trace_line_away(struct trace_lines *t, const struct node *n);
/* As trace_line(), for the address behind a poll or call. */
const char *trace_line_at(struct trace_lines *t, const struct node *n, uintptr_t address);
#endif
