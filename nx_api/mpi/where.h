/* where.h - a program's place, for messages: its calls under way, with functions and source lines, each in a
 * line of its own:
 *
 *       in strlen() of a library
 *       called from show() (report.c:12)
 *       which interrupted main() (report.c:40)
 */
#ifndef MPI_WHERE_H
#define MPI_WHERE_H
#include "nx_api/mpi/safe_text.h"

/* Appends the lines; nothing if the program has not begun. In a handler of a signal context is its third
 * argument; else NULL: the program is in a call of libnx.a. Takes some 10 ms. */
void where_append(struct safe_text *t, const void *context);
/* Call this once before: what it needs is loaded then. */
void where_begin(void);
#endif
