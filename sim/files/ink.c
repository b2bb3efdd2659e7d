/* ink.c - see ink.h. */
#include "files/ink.h"
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool is_set(const char *name)
{
    const char *value = getenv(name);
    return value && *value;
}

static bool is_coloured(FILE *f)
{
    const char *force = getenv("CLICOLOR_FORCE"), *terminal = getenv("TERM");
    if (fileno(f) < 0 || is_set("NO_COLOR"))
        return false;
    if (force && *force && strcmp(force, "0"))
        return true;
    return isatty(fileno(f)) == 1 && !is_set("OMPI_COMM_WORLD_SIZE") && terminal && *terminal &&
           strcmp(terminal, "dumb");
}

struct ink ink_for(FILE *f)
{
    static const struct ink COLOURS = {"\033[1m", "\033[31m", "\033[33m", "\033[32m", "\033[0m"};
    return is_coloured(f) ? COLOURS : (struct ink){"", "", "", "", ""};
}
