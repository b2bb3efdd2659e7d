/* sensitivity.c - see sensitivity.h: the numbers, their steps, and what comes of them. */
#include "lab/sensitivity/sensitivity.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "files/words.h"

/* A key's end tells the unit and the least step that counts: a picosecond, a hertz, one. */
static const struct unit {
    const char *end, *name;
    double grain;
} UNITS[] = {{"_us_per_byte", "us/B", 1e-6},
             {"_ns_per_byte", "ns/B", 1e-3},
             {"_mb_per_s", "MB/s", 1e-6},
             {"_us", "us", 1e-6},
             {"_ns", "ns", 1e-3},
             {"_ms", "ms", 1e-9},
             {"_mhz", "MHz", 1e-6},
             {"_factor", "", 1e-3},
             {"program_share", "", 1e-3},
             {"_kb", "KB", 1},
             {"_mb", "MB", 1},
             {"", "", 1}};

static const struct unit *unit_of(const char *key)
{
    const struct unit *u = UNITS;
    size_t length = strlen(key), end;
    while ((end = strlen(u->end)) > length || strcmp(key + length - end, u->end) != 0)
        u++;
    return u;
}

/* --- the re-runs ---------------------------------------------------------------------------------------- */

/* NULL, or why the machine cannot have that besides its settings. */
static char *refusal(const struct cfg_machine *cfg, const char *setting)
{
    char *error = NULL, **set = NULL;
    words_add_each(&set, NULL, (const char *const *)cfg->set);
    words_add(&set, xstrdup(setting));
    cfg_free(cfg_load_with(cfg->path, NULL, (const char *const *)set, &error));
    words_free(set);
    return error;
}

/* As many of its unit's grains as 1 % has, and at least one, on that side. */
static char *setting_of(struct sensitive_number *n, double grain, int side)
{
    double grains = round(n->value / grain), more = side * fmax(1, round(fabs(n->value) / 100 / grain));
    n->step = more * grain;
    return xasprintf("%s=%.15g", n->number->key, (grains + more) * grain);
}

/* Upwards, or where the machine does not allow that, downwards. */
static void add_number(struct sensitivity *s, const struct cfg_machine *cfg, const struct cfg_number *number)
{
    const struct unit *u = unit_of(number->key);
    struct sensitive_number n = {.number = number, .unit = u->name, .value = strtod(number->value, NULL)};
    char *setting = setting_of(&n, u->grain, 1);
    if ((n.refused = refusal(cfg, setting))) {
        free(setting);
        setting = setting_of(&n, u->grain, -1);
        char *again = refusal(cfg, setting);
        if (!again) {
            free(n.refused);
            n.refused = NULL;
        }
        free(again);
    }
    n.run = s->runs.count;
    if (n.refused)
        free(setting);
    else
        words_add(&reruns_add(&s->runs, number->key, xstrdup(number->key))->set, setting);
    s->list = xreallocarray(s->list, s->count + 1, sizeof *s->list);
    s->list[s->count++] = n;
}

struct sensitivity *sensitivity_new(const struct cfg_machine *cfg, char **error)
{
    struct sensitivity *s = xcalloc(1, sizeof *s);
    if (!(s->numbers = cfg_numbers_read(cfg, error))) {
        sensitivity_free(s);
        return NULL;
    }
    reruns_add(&s->runs, "as it was", xstrdup("as it was"));
    for (size_t i = 0; i < s->numbers->count; i++) {
        const struct cfg_number *n = &s->numbers->list[i];
        if (n->is_number && strncmp(n->key, "cpu.", 4) != 0 && strtod(n->value, NULL) != 0)
            add_number(s, cfg, n);
    }
    return s;
}

/* --- what comes of them --------------------------------------------------------------------------------- */

/* Seconds for 1 % more. */
static double effect(const struct sensitivity *s, const struct sensitive_number *n)
{
    const struct rerun *x = &s->runs.list[n->run];
    if (n->refused || !x->done)
        return NAN;
    double change = (double)((int64_t)x->end - (int64_t)s->runs.list[0].end) / (double)VT_SECOND;
    return change / (100 * n->step / n->value) + 0.0; /* no -0 */
}

/* The largest effects first, then numbers without an answer; equal ones in the file's order. */
static int by_effect(const void *a, const void *b)
{
    const struct sensitive_number *x = a, *y = b;
    double dx = isnan(x->per_percent) ? -1 : fabs(x->per_percent),
           dy = isnan(y->per_percent) ? -1 : fabs(y->per_percent);
    return dx != dy ? (dx < dy) - (dx > dy) : (x->number > y->number) - (x->number < y->number);
}

bool sensitivity_run(struct sensitivity *s, const struct rerun_place *p, vtime end, char **error)
{
    if (!rerun_some(p, &s->runs, 0, s->runs.count, error))
        return false;
    const struct rerun *same = &s->runs.list[0];
    if (!same->done)
        *error = xasprintf("the program cannot be run again: %s", same->error);
    else if (same->end != end)
        *error =
            xasprintf("the program takes %.12f s when it is run again, not %.12f s: it reads what it has "
                      "written, or its input has changed",
                      vt_seconds(same->end), vt_seconds(end));
    for (size_t i = 0; i < s->count && !*error; i++)
        s->list[i].per_percent = effect(s, &s->list[i]);
    qsort(s->list, s->count, sizeof *s->list, by_effect);
    return !*error;
}

void sensitivity_free(struct sensitivity *s)
{
    for (size_t i = 0; i < s->count; i++)
        free(s->list[i].refused);
    free(s->list);
    if (s->numbers)
        cfg_numbers_free(s->numbers);
    reruns_free(&s->runs);
    free(s);
}
