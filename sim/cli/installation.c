/* installation.c - see installation.h. */
#include "cli/installation.h"
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "cli/say.h"
#include "config/config.h"

static bool find_binary(struct cli_installation *i)
{
    ssize_t n = readlink("/proc/self/exe", i->runner, sizeof i->runner - 1);
    i->runner[n > 0 ? n : 0] = '\0';
    return n > 0;
}

bool cli_find_installation(struct cli_installation *i, const char *command)
{
    if (!find_binary(i) || !cfg_home(i->home, sizeof i->home)) {
        cli_say_error(command,
                      "machines/ is not where this program was built or installed; set TOUCHSTONE_HOME");
        return false;
    }
    int folder = (int)(strrchr(i->runner, '/') - i->runner);
    snprintf(i->machines, sizeof i->machines, "%s/machines", i->home);
    snprintf(i->programs, sizeof i->programs, "%.*s/../lib/touchstone", folder, i->runner);
    if (access(i->programs, X_OK) != 0)
        snprintf(i->programs, sizeof i->programs, "%.*s", folder, i->runner);
    return true;
}
