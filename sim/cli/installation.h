/* installation.h - the places of the binary that simulates, and of touchstone's own files. */
#ifndef CLI_INSTALLATION_H
#define CLI_INSTALLATION_H
#include <limits.h>
#include <stdbool.h>

struct cli_installation {
    char runner[PATH_MAX]; /* the binary that simulates: this one, or the one that has started this one */
    char programs[PATH_MAX + 32]; /* the folder of the node programs: the binary's, or lib/touchstone */
    char home[PATH_MAX];          /* the folder of machines/ and bench/ */
    char machines[PATH_MAX + 16]; /* home/machines */
};

/* Returns false, after a message of the command on standard error, if they are not found. */
bool cli_find_installation(struct cli_installation *i, const char *command);

/* Is this the path of touchstone-lab (other_binary.h)? */
bool cli_is_lab(const char *path);
#endif
