/* engine_switch.c - the other engine is in another binary, which has the same commands. */
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli/commands.h"
#include "cli/options.h"
#include "lp/engine.h"

bool cli_is_other_engine(const char *engine)
{
    return strcmp(engine, ENGINE_NAME) && (!strcmp(engine, "fast") || !strcmp(engine, "reference"));
}

int cli_change_engine(const char *engine, char **argv)
{
    /* in a build, both binaries are in one folder; installed, the reference is in lib/touchstone */
    static const char *const PLACES[] = {"/touchstone%s", "/../lib/touchstone/touchstone%s",
                                         "/../../bin/touchstone%s"};
    char path[PATH_MAX], *slash;
    ssize_t length = readlink("/proc/self/exe", path, sizeof path - 64);
    path[length < 0 ? 0 : length] = 0;
    if (!(slash = strrchr(path, '/'))) {
        fprintf(stderr, "touchstone: engine '%s': /proc is not mounted, so its binary cannot be found\n",
                engine);
        return CLI_EXIT_INPUT;
    }
    unsetenv("TOUCHSTONE_ENGINE"); /* else the other binary would obey it, too */
    for (size_t i = 0; i < sizeof PLACES / sizeof *PLACES; i++) {
        sprintf(slash, PLACES[i], strcmp(engine, "reference") ? "" : "-reference");
        execv(path, argv);
    }
    fprintf(stderr, "touchstone: engine '%s': %s cannot be run: %s\n", engine, path, strerror(errno));
    return CLI_EXIT_INPUT;
}
