/* virtual_time.c - see virtual_time.h. */
#include "files/virtual_time.h"
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
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

/* "1.500000" as "1.5". */
static void cut_zeros(char *number)
{
    size_t length = strlen(number);
    if (!strchr(number, '.'))
        return;
    while (number[length - 1] == '0')
        length--;
    number[length - (number[length - 1] == '.')] = '\0';
}

struct time_text virtual_time_moment(vtime t)
{
    static const int DIGITS[] = {9, 6, 3, 3}; /* of each unit */
    struct time_text x;
    char number[24];
    int i = 0;
    while (i < 3 && t && t < UNITS[i].ps)
        i++;
    snprintf(number, sizeof number, "%.*f", DIGITS[i], (double)t / (double)UNITS[i].ps);
    cut_zeros(number);
    snprintf(x.text, sizeof x.text, "%s %s", number, UNITS[i].name);
    return x;
}

/* The unit for a number of seconds, of UNITS. What is less after rounding to four digits has the larger. */
static int unit_for(double seconds)
{
    double ps = fabs(seconds) * (double)VT_SECOND;
    int i = 0;
    while (i < 3 && ps > 0 && ps < 0.99995 * (double)UNITS[i].ps)
        i++;
    return i;
}

static double in_unit(double seconds, int i)
{
    return seconds * (double)VT_SECOND / (double)UNITS[i].ps;
}

struct time_text duration_text(double seconds)
{
    struct time_text x;
    int i = unit_for(seconds), decimals = seconds != 0 ? 3 : 0;
    double value = in_unit(seconds, i);
    for (double limit = 9.9995; decimals > 0 && fabs(value) >= limit; limit *= 10)
        decimals--;
    snprintf(x.text, sizeof x.text, "%.*f %s", decimals, value, UNITS[i].name);
    return x;
}

struct time_text limit_text(double seconds)
{
    struct time_text x;
    int i = unit_for(seconds);
    snprintf(x.text, sizeof x.text, "%.15g %s", in_unit(seconds, i), UNITS[i].name);
    return x;
}

char *virtual_time_text(vtime t)
{
    size_t i = 0;
    while (i + 1 < NAMED && t % UNITS[i].ps)
        i++;
    return xasprintf("%" PRIu64 "%s", t / UNITS[i].ps, UNITS[i].name);
}
