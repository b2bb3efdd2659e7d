/* layer.h - functions that reports do not name: NX's own library, and those of a message
 * layer, which stands between the program and NX (touchstone run --layer). The frame that a report names is
 * the innermost that is of neither, be it inlined; if all are of the layer, the innermost of these. */
#ifndef GUEST_LAYER_H
#define GUEST_LAYER_H
#include <stdbool.h>
#include <stdint.h>

struct elf_file;

/* Is a source file, named from the root of touchstone's source or by its whole path, NX's library's? */
bool layer_is_library(const char *path);
/* Is it MPI's? */
bool layer_is_mpi(const char *path);
/* What a program calls a function of the library: "MPI_Send" of PMPI_Send. "": nothing; the function lies
 * between such a call and the library. */
const char *layer_called(const char *function);
/* Does one of the patterns, ended by NULL, match? Patterns have * and ?, as file names in a shell. One with a
 * '/' is about whole paths of source files, one with a '.' about source files without their folders
 * ("mpi*.c"), any other about functions ("MPI*"). layer may be NULL: no patterns; function and path, too: not
 * known. */
bool layer_has(char *const *layer, const char *function, const char *path);

struct layer_place {
    char
        *function; /* malloc'd; "": not known. Without a layer inlined functions do not count: the symbol's */
    char *path;    /* malloc'd, as the compiler was given it; NULL: no line is known */
    int line;      /* from 1 on; 0: not known */
    bool in_layer;
};

/* The frame that reports name, of those that GCC has made one by inlining at an address of a program's file.
 * The caller frees the two texts. */
struct layer_place layer_place(const struct elf_file *f, char *const *layer, uint64_t address);
#endif
