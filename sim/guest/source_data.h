/* source_data.h - the name that the source gives to static data at an address, by the program's debugging
 * information (read with libdw of elfutils). Knows nothing of nodes. */
#ifndef GUEST_SOURCE_DATA_H
#define GUEST_SOURCE_DATA_H
#include <stddef.h>
#include <stdint.h>

/* As source_line(): the file is in memory, the address is one of the file. Returns the name (malloc'd) of the
 * variable whose bytes the address is one of, also of one in a Fortran common block; NULL if the file does
 * not say. Not to be called on a node's stack. */
char *source_data(const void *file, size_t bytes, uint64_t address);
#endif
