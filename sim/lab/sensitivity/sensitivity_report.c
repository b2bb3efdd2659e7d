/* sensitivity_report.c - see sensitivity_report.h. */
#include "lab/sensitivity/sensitivity_report.h"
#include <math.h>
#include <stdlib.h>
#include "files/json_set.h"
#include "files/virtual_time.h"
#include "kernel/xalloc.h"

enum { ROWS = 10 };

static double time_of(const struct sensitivity *s)
{
    return vt_seconds(s->runs.list[0].end);
}

/* How many numbers change the time. */
static size_t changing(const struct sensitivity *s)
{
    size_t count = 0;
    while (count < s->count && fabs(s->list[count].per_percent) > 0)
        count++;
    return count;
}

static void print_row(const struct sensitivity *s, const struct sensitive_number *n, FILE *f)
{
    double percent = time_of(s) > 0 ? 100 * n->per_percent / time_of(s) : 0;
    char *value = xasprintf("%.15g%s%s", n->value, *n->unit ? " " : "", n->unit);
    char *step = xasprintf("%+.6g (%+.4g %%)", n->step, 100 * n->step / n->value);
    fprintf(f, "%s%-*s %+8.4f  %-28s %-16s %-20s %s\n", n->per_percent > 0 ? "+" : "",
            n->per_percent > 0 ? 11 : 12, duration_text(n->per_percent).text, percent, n->number->key, value,
            step, n->number->standing);
    free(value);
    free(step);
}

static const char *no_answer(const struct sensitivity *s, const struct sensitive_number *n)
{
    return n->refused ? n->refused : s->runs.list[n->run].error;
}

void sensitivity_print(const struct sensitivity *s, const char *name, const char *machine, FILE *f)
{
    size_t some = changing(s), rows = some < ROWS ? some : ROWS, without = 0;
    fprintf(
        f,
        "\nThe time of %s on %s is %s. With 1 %% more of a number it changes by (a run for each number):\n",
        name, machine, virtual_time_moment(s->runs.list[0].end).text);
    fprintf(f, "%-12s %8s  %-28s %-16s %-20s %s\n", "change", "% of it", "number", "value", "step",
            "standing");
    for (size_t i = 0; i < rows; i++)
        print_row(s, &s->list[i], f);
    for (size_t i = 0; i < s->count; i++)
        if (isnan(s->list[i].per_percent) && ++without)
            fprintf(f, "no answer for %s: %s\n", s->list[i].number->key, no_answer(s, &s->list[i]));
    if (some > rows)
        fprintf(f, "%zu more of %zu numbers change the time, by less. ", some - rows, s->count);
    fprintf(
        f,
        "%zu numbers do not change it. node.clock_mhz stands for the clocks of all operations, which nxcc "
        "counts.\n",
        s->count - some - without);
}

static json_t *number_json(const struct sensitivity *s, const struct sensitive_number *n)
{
    json_t *o = xchecked(json_pack("{s:s, s:f, s:s, s:f, s:s, s:s}", "key", n->number->key, "value", n->value,
                                   "unit", n->unit, "step", n->step, "standing", n->number->standing,
                                   "source", n->number->source));
    if (isnan(n->per_percent)) {
        json_set(o, "no_answer", json_text(no_answer(s, n)));
    } else {
        json_set(o, "virtual_time_s", json_real(vt_seconds(s->runs.list[n->run].end)));
        json_set(o, "s_per_percent", json_real(n->per_percent));
    }
    return o;
}

json_t *sensitivity_json(const struct sensitivity *s)
{
    json_t *all = xchecked(json_array());
    for (size_t i = 0; i < s->count; i++)
        json_append(all, number_json(s, &s->list[i]));
    return all;
}
