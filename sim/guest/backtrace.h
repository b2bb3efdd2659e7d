/* backtrace.h - a backtrace: the calls under way on its node's stack, found by the frame pointers that
 * nxcc keeps. */
#ifndef GUEST_BACKTRACE_H
#define GUEST_BACKTRACE_H
#include <stdio.h>
#include "node/node.h"

/* Does an address, and the next word, lie in a stack of the node's program? */
bool backtrace_in_stack(const struct node *n, uintptr_t address);
/* Writes the return addresses of the calls from a frame upwards, at most `most`, and returns how many. Safe
 * in a signal handler. */
int backtrace_walk(const struct node *n, uintptr_t frame, uintptr_t *returns, int most);
bool backtrace_in_program(const struct node *n, uintptr_t address);
/* As backtrace_walk(), but only addresses in the program: what lies between two of its functions, where a
 * handler has interrupted, is left out. */
int backtrace_program_calls(const struct node *n, uintptr_t frame, void **returns, int most);
/* Prints calls by their addresses, the innermost first: a newline and "  HOW FUNCTION (FILE:LINE)" for the
 * first, then "  called from ..."; nothing for an address outside of the program. */
void backtrace_print(FILE *f, const struct node *n, const char *how, const uintptr_t *addresses, int count);
/* Prints calls in that way, a recursion in one line, but each call's text by `print`, which returns false for
 * one that has none. */
typedef bool backtrace_print_call(FILE *f, const struct node *n, const char *how, uintptr_t address);
void backtrace_print_as(backtrace_print_call *print, FILE *f, const struct node *n, const char *how,
                        const uintptr_t *addresses, int count);
/* Prints such a line for each call under way in the program, from a frame upwards. */
void backtrace_print_calls(FILE *f, const struct node *n, uintptr_t frame);

/* The call of MPI's in which the program is, "MPI_Send", by the addresses of its frames, the innermost first;
 * *outside becomes how many frames of the call there are. NULL: it is in none. */
const char *backtrace_mpi_call(const struct node *n, const uintptr_t *frames, int depth, int *outside);

/* The name of the library function whose call returns to an address of the program; NULL if the call's
 * instruction does not tell. */
const char *backtrace_called(const struct node *n, uintptr_t returns);

/* The source lines in which nodes wait, each found once: finding one takes milliseconds of host time, and
 * many nodes wait in one line. */
struct backtrace_lines;
struct backtrace_lines *backtrace_lines_new(void);
void backtrace_lines_free(struct backtrace_lines *t);
/* "FILE:LINE" of the call in which a blocked node's program waits, in the function that reports name
 * (guest/layer.h); NULL if it is not known. t keeps the text. */
const char *backtrace_line(struct backtrace_lines *t, const struct node *n);
/* The same of any program that does not run at the moment, wherever it has switched away. */
const char *backtrace_line_away(struct backtrace_lines *t, const struct node *n);
/* As backtrace_line(), from a frame upwards, of a program that runs or not. */
const char *backtrace_line_from(struct backtrace_lines *t, const struct node *n, uintptr_t frame);
/* As backtrace_line(), for calls by their return addresses, the innermost first; a 0 ends them early. */
const char *backtrace_line_of(struct backtrace_lines *t, const struct node *n, const uintptr_t *returns,
                              int depth);
/* As backtrace_line(), for the address behind one poll or call, whoever makes it. */
const char *backtrace_line_at(struct backtrace_lines *t, const struct node *n, uintptr_t address);
#endif
