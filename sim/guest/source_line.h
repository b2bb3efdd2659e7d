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

/* What the source calls the function around the address, malloc'd: "step" of a Fortran program, whose symbol
 * is step_. NULL: the file does not say. */
char *source_function(const void *file, size_t bytes, uint64_t address);

enum { SOURCE_MOST_FRAMES = 16 };

struct source_frame {
    char *function; /* malloc'd; NULL: not inlined, the program's symbols name it */
    char *path;     /* malloc'd */
    int line;
};

/* Finds the line of source_line(), and those of the calls whose functions GCC has inlined around the
 * address, outwards. Returns how many; 0: the file does not say. */
size_t source_frames(const void *file, size_t bytes, uint64_t address,
                     struct source_frame frames[SOURCE_MOST_FRAMES]);
#endif
