/* virtual_time.c - see virtual_time.h. */
#include "files/virtual_time.h"
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

static const struct {
    const char *name;
    uint64_t ps;
} UNITS[] = {{"s", 1000000000000}, {"ms", 1000000000}, {"us", 1000000},
             {"ns", 1000},         {"ps", 1},          {"", 1000000000000}};
enum { NAMED = sizeof UNITS / sizeof *UNITS - 1 }; /* the units that are written */

bool virtual_time_read(const char *text, vtime *t)
{
    char *end;
    errno = 0;
    double value = strtod(text, &end);
    for (size_t i = 0; i < sizeof UNITS / sizeof *UNITS; i++)
        if (end != text && !errno && value >= 0 && !strcmp(end, UNITS[i].name) &&
            value * (double)UNITS[i].ps < 0x1p63) {
            *t = (vtime)llround(value * (double)UNITS[i].ps);
            return true;
        }
    return false;
}

char *virtual_time_text(vtime t)
{
    size_t i = 0;
    while (i + 1 < NAMED && t % UNITS[i].ps)
        i++;
    return xasprintf("%" PRIu64 "%s", t / UNITS[i].ps, UNITS[i].name);
}
