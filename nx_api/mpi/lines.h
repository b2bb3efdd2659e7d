/* lines.h - functions and source lines of addresses of the program's code, by its debugging information
 * (-g), which binutils' addr2line reads. Without -g only functions are known; without addr2line, nothing. */
#ifndef MPI_LINES_H
#define MPI_LINES_H
#include <stddef.h>
#include <stdint.h>

struct lines;
/* Finds those of the addresses behind calls (stack.h: as the file has them) at once: takes some 10 ms. */
struct lines *lines_find(const uint64_t *addresses, size_t count);
void lines_free(struct lines *l);
/* "ring.c:17", and "exchange"; NULL: not known. For an address that was given; lasts as long as l. */
const char *lines_at(const struct lines *l, uint64_t address);
const char *lines_function(const struct lines *l, uint64_t address);
#endif
