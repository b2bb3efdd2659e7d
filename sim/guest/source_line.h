/* source_line.h - the source line that an address of a program's code was compiled from, by the program's
 * debugging information (read with libdw of elfutils). Knows nothing of nodes. */
#ifndef GUEST_SOURCE_LINE_H
#define GUEST_SOURCE_LINE_H
#include <stddef.h>
#include <stdint.h>

/* The ELF file is in memory, with its 64-bit tables checked (elffile.h); the address is one of the file,
 * not of a node. Returns the path of the source file (malloc'd) and sets *line (from 1 up). Returns NULL if
 * the file does not say, for instance if the program was built without -g. Can be called on a node's stack,
 * however small. */
char *source_line(const void *file, size_t bytes, uint64_t address, int *line);
#endif
