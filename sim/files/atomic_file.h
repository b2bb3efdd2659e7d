/* atomic_file.h - a file that a run leaves: it is there whole or not at all, and never takes the place of what is not ours.
 *
 *   "-"                                     standard output
 *   what is there and is no ordinary file   a pipe, a device, a link: written through
 *   any other name                          written under another name, then renamed
 */
#ifndef FILES_ATOMIC_FILE_H
#define FILES_ATOMIC_FILE_H
#include <stdbool.h>
#include <stdio.h>

struct atomic_file {
    FILE *out; /* write here */
    char *path;
    char *unfinished; /* NULL: it is written where it is */
};

/* Begins it. false with *error a malloc'd text for the user. */
bool atomic_file_begin(struct atomic_file *f, const char *path, char **error);
/* Ends it, and makes it there under its name if all was written. */
bool atomic_file_end(struct atomic_file *f, char **error);
/* Ends it; a file written under another name leaves no trace. */
void atomic_file_drop(struct atomic_file *f);
#endif
