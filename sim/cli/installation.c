/* installation.c - see installation.h. */
#include "cli/installation.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "cli/other_binary.h"
#include "cli/say.h"
#include "config/config.h"

bool cli_is_lab(const char *path)
{
    const char *slash = strrchr(path, '/');
    return !strcmp(slash ? slash + 1 : path, "touchstone-lab");
}

static bool find_runner(struct cli_installation *i)
{
    if (!cli_own_path(i->runner, sizeof i->runner))
        return false;
    if (cli_is_lab(i->runner)) /* it is called by the path of the binary that has started it */
        snprintf(i->runner, sizeof i->runner, "%s", program_invocation_name);
    return true;
}

bool cli_find_installation(struct cli_installation *i, const char *command)
{
    if (!find_runner(i) || !cfg_home(i->home, sizeof i->home)) {
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
