/* program_file.h - a program that somebody names: where it is, and on how many nodes it runs. */
#ifndef FILES_PROGRAM_FILE_H
#define FILES_PROGRAM_FILE_H
#include <stdint.h>

/* A program with its arguments, on some nodes of a run. argv[0] is its path. */
struct named_program {
    uint32_t nodes;
    int argc;
    char **argv;
};

/* So many of the words, 1 or more of them, are a program's with its arguments. Then comes another one:
 * `: -n NODES PROGRAM`, as mpiexec takes them. */
int named_program_words(char *const *words, int count);

/* The path of the program `name`, malloc'd. A relative name is looked for in the folder `here` (NULL: the
 * current one), then in the folder `brought` of the programs that come with touchstone. If it is in none,
 * NULL, and *error, malloc'd, lists where it was looked for. */
char *program_file_find(const char *name, const char *here, const char *brought, char **error);
#endif
