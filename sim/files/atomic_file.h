/* atomic_file.h - a result file that appears complete or not at all. The name decides how the file is
 * written:
 *
 *   "-"                                        to standard output
 *   an existing pipe, device or symbolic link   into what is there: it is never replaced
 *   any other name                              under a temporary name beside it, then renamed
 */
#ifndef FILES_ATOMIC_FILE_H
#define FILES_ATOMIC_FILE_H
#include <stdbool.h>
#include <stdio.h>

struct atomic_file {
    FILE *out; /* write here */
    char *path;
    char *unfinished; /* the temporary name; NULL: written directly */
    int lock;         /* which says that its process lives; -1: none */
};

/* Could the file be begun now? False with *error, a malloc'd text for the user. For results of long work,
 * before it. Opens nothing. */
bool atomic_file_possible(const char *path, char **error);

/* Opens f->out for writing. False with *error, a malloc'd text for the user. */
bool atomic_file_begin(struct atomic_file *f, const char *path, char **error);
/* As atomic_file_begin(), long before the first byte is written: what a symbolic link leads to stays as it is
 * until atomic_file_replace(), which is to be called before that byte. */
bool atomic_file_reserve(struct atomic_file *f, const char *path, char **error);
void atomic_file_replace(struct atomic_file *f);
/* Closes the file and, if all was written, gives it its name. False with *error malloc'd: nothing was left
 * behind. */
bool atomic_file_end(struct atomic_file *f, char **error);
/* A whole file of these bytes. False with *error malloc'd. */
bool atomic_file_write(const char *path, const void *bytes, size_t size, char **error);
/* Gives the file up: removes what was written under the temporary name. */
void atomic_file_drop(struct atomic_file *f);

/* From now on SIGINT, SIGTERM and SIGHUP remove the file that was begun last before they end the process: for
 * commands that write one file at a time and do nothing else at a signal. */
void atomic_file_drop_at_signals(void);
/* And this folder, with all that is in it. The path must last; NULL: none any more. */
void atomic_file_drop_folder_at_signals(const char *path);

/* Removes what killed processes left that were writing a file to that path. It reads the folder: for files
 * whose writing takes as long as a run. */
void atomic_file_remove_left(const char *path);
#endif
