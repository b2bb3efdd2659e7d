/* host_files.h - the option --host-files: files of this computer that programs may use beside those below the
 * current folder. */
#ifndef CLI_HOST_FILES_H
#define CLI_HOST_FILES_H
#include "cli/options.h"
#include "guest/libc/fence.h"

/* Values of the option, PATH or PATH:ro, ended by NULL; or NULL: none. */
struct cli_host_files {
    const char **list; /* to be freed by the caller */
    size_t count;
};

/* --host-files; input: struct cli_host_files *. */
extern const struct argp CLI_HOST_FILES;
/* --host-files of commands that start runs: the values go into the environment, where the runs find them.
 * Input: struct cli_host_files *, in which they are kept, too; or NULL. */
extern const struct argp CLI_RUNS_HOST_FILES;

/* The fence round a run: the current folder, the option's values, those of the environment, and, to be read,
 * the files that words name: the program's arguments. NULL with *error malloc'd. */
struct fence *cli_fence(const struct cli_host_files *files, char *const *words, int count, char **error);
#endif
