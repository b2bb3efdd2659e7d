/* draw_read.c - see draw_read.h. */
#include "timing/draw_read.h"
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "files/virtual_time.h"
#include "kernel/xalloc.h"

static bool read_whole(const char *text, uint64_t least, uint64_t most, uint64_t *value)
{
    char *end;
    errno = 0;
    *value = strtoull(text, &end, 10);
    return *text >= '0' && *text <= '9' && !*end && !errno && *value >= least && *value <= most;
}

/* "2%" */
static bool read_percent(const char *text, uint32_t *ppm)
{
    char *end;
    double percent = strtod(text, &end);
    if (end == text || strcmp(end, "%") || !(percent >= 0 && percent * 10000 <= DRAW_SLOWEST_PPM))
        return false;
    *ppm = (uint32_t)lround(percent * 10000);
    return true;
}

static bool read_method(const char *text, enum draw_method *method)
{
    bool pct = !strcmp(text, "pct");
    *method = pct ? DRAW_PCT : DRAW_RANDOM;
    return pct || !strcmp(text, "random");
}

static bool read_depth(const char *text, uint32_t *depth)
{
    uint64_t value;
    bool good = read_whole(text, 1, DRAW_DEEPEST, &value);
    *depth = good ? (uint32_t)value : *depth;
    return good;
}

/* Reads one suboption; returns NULL, or what it takes. */
static const char *read_suboption(const char *key, const char *value, struct draw *d)
{
    static const char TIME[] = "a virtual time such as 100us";
    if (!strcmp(key, "method"))
        return read_method(value, &d->method) ? NULL : "random or pct";
    if (!strcmp(key, "depth"))
        return read_depth(value, &d->depth) ? NULL : "a number from 1 to 100";
    if (!strcmp(key, "length"))
        return read_whole(value, 1, UINT64_MAX / 2, &d->length) ? NULL
                                                                : "a number of messages and interrupts";
    if (!strcmp(key, "messages"))
        return virtual_time_read(value, &d->messages) ? NULL : TIME;
    if (!strcmp(key, "interrupts"))
        return virtual_time_read(value, &d->interrupts) ? NULL : TIME;
    if (!strcmp(key, "start"))
        return virtual_time_read(value, &d->start) ? NULL : TIME;
    if (!strcmp(key, "speed"))
        return read_percent(value, &d->speed_ppm) ? NULL : "0% to 1000%";
    return "";
}

static char *read_item(char *item, struct draw *d)
{
    char *value = strchr(item, '=');
    if (!value)
        return xasprintf("'%s' is no suboption: those are KEY=VALUE", item);
    *value++ = '\0';
    const char *takes = read_suboption(item, value, d);
    if (!takes)
        return NULL;
    if (!*takes)
        return xasprintf("there is no suboption '%s': there are method, depth, length, messages, interrupts, "
                         "speed and start",
                         item);
    return xasprintf("%s takes %s, not '%s'", item, takes, value);
}

char *draw_read(const char *text, struct draw *d)
{
    char *copy = xstrdup(text), *rest = copy, *error = NULL;
    const char *seed = strsep(&rest, ",");
    *d = draw_usual();
    if (!read_whole(seed, 0, UINT64_MAX, &d->seed))
        error = xasprintf("a seed, a whole number, comes first, not '%s'", seed);
    while (rest && !error)
        error = read_item(strsep(&rest, ","), d);
    free(copy);
    return error;
}

char *draw_text(const struct draw *d)
{
    char *pct = d->method != DRAW_PCT
                    ? xstrdup("random")
                    : xasprintf("pct,depth=%" PRIu32 ",length=%" PRIu64, d->depth, d->length);
    char *messages = virtual_time_text(d->messages), *interrupts = virtual_time_text(d->interrupts);
    char *start = virtual_time_text(d->start);
    char *text = xasprintf("%" PRIu64 ",method=%s,messages=%s,interrupts=%s,speed=%.10g%%,start=%s", d->seed,
                           pct, messages, interrupts, (double)d->speed_ppm / 10000, start);
    free(start);
    free(interrupts);
    free(messages);
    free(pct);
    return text;
}
