/* other_binary.c - see other_binary.h. */
#include "cli/other_binary.h"
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli/options.h"
#include "lp/engine.h"

static const char LAB[] = "touchstone-lab";

bool cli_own_path(char *path, size_t size)
{
    ssize_t length = readlink("/proc/self/exe", path, size - 1);
    path[length > 0 ? length : 0] = '\0';
    if (length <= 0)
        fprintf(stderr, "touchstone: /proc is not mounted, so touchstone's binaries cannot be found\n");
    return length > 0;
}

int cli_execute(const char *binary, char **argv)
{
    static const char *const PLACES[] = {"/%s", "/../lib/touchstone/%s", "/../../bin/%s"};
    char path[PATH_MAX];
    if (!cli_own_path(path, sizeof path - 64))
        return CLI_EXIT_INPUT;
    char *slash = strrchr(path, '/');
    for (size_t i = 0; i < sizeof PLACES / sizeof *PLACES; i++) {
        sprintf(slash, PLACES[i], binary);
        execv(path, argv);
    }
    *slash = '\0';
    if (errno == ENOENT && !strcmp(binary, LAB)) {
        fprintf(
            stderr,
            "touchstone %s: this needs touchstone-lab, which is not installed with this touchstone: install "
            "the package touchstone-lab that make deb has built with touchstone's\n",
            argv[1]);
        return CLI_EXIT_INPUT;
    }
    fprintf(stderr, "touchstone: %s cannot be run from %s: %s; is the installation complete?\n", binary, path,
            strerror(errno));
    return CLI_EXIT_INPUT;
}

int cli_hand_to_lab(char **argv)
{
    char self[PATH_MAX];
    if (!cli_own_path(self, sizeof self))
        return CLI_EXIT_INPUT;
    argv[0] = self;
    return cli_execute(LAB, argv);
}

bool cli_is_engine(const char *engine)
{
    return !strcmp(engine, "fast") || !strcmp(engine, "reference");
}

bool cli_is_other_engine(const char *engine)
{
    return strcmp(engine, ENGINE_NAME) && cli_is_engine(engine);
}

int cli_change_engine(const char *engine, char **argv)
{
    unsetenv("TOUCHSTONE_ENGINE"); /* else the other binary would obey it, too */
    return cli_execute(strcmp(engine, "reference") ? "touchstone" : "touchstone-reference", argv);
}
