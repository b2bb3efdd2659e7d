/* addr2line.h - binutils' addr2line, which knows functions and source lines of a program with debugging
 * information (-g), or functions only. All functions may be called in a handler of a signal. */
#ifndef MPI_ADDR2LINE_H
#define MPI_ADDR2LINE_H
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

enum { ADDR2LINE_DIGITS = 20, ADDR2LINE_BEFORE = 4 };

/* Starts it for this program. argv has ADDR2LINE_BEFORE entries to be filled in, then the addresses as the
 * file has them (addr2line_digits), and NULL. From the descriptor returned come two lines for each address;
 * -1: there is no addr2line. The child is to be waited for. */
int addr2line_start(const char **argv, pid_t *child);
void addr2line_digits(char digits[ADDR2LINE_DIGITS], uint64_t address);

/* The place, "ring.c:17", out of an address's second line, and its function, "exchange", out of the first:
 * they cut them up. NULL: not known. */
char *addr2line_place(char *line);
char *addr2line_function(char *line, const char *place);
#endif
