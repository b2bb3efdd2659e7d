/* installation.h - where this binary and touchstone's own files are. */
#ifndef CLI_INSTALLATION_H
#define CLI_INSTALLATION_H
#include <limits.h>
#include <stdbool.h>

struct cli_installation {
    char runner[PATH_MAX]; /* this binary */
    char programs[PATH_MAX +
                  32];   /* node programs that come with it: beside it in a build, else in lib/touchstone */
    char home[PATH_MAX]; /* the folder of machines/ and bench/ */
    char machines[PATH_MAX + 16]; /* home/machines */
};

/* False, with a message of the command on standard error, if they are not found. */
bool cli_find_installation(struct cli_installation *i, const char *command);
#endif
