/* outcome.c - reads what a run came to; see outcome.h. */
#include "lab/jobs/outcome.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The number at text as JSON, a whole number as an integer if 64 bits hold it. NULL unless the number ends at
 * a blank or the text's end. */
static json_t *number(const char *text, char **end)
{
    errno = 0;
    long long whole = strtoll(text, end, 10);
    if (!errno && *end != text && (**end == '\0' || isspace((unsigned char)**end)))
        return json_integer(whole);
    double real = strtod(text, end);
    if (*end == text || (**end && !isspace((unsigned char)**end)) || !isfinite(real))
        return NULL;
    return json_real(real);
}

/* "value" as a number, "value value ..." as a list of numbers; NULL if any value is not a number. */
static json_t *values(const char *text)
{
    json_t *list = json_array(), *value;
    char *end;
    for (;; text = end) {
        text += strspn(text, " \t\r");
        if (!*text)
            break;
        if (!(value = number(text, &end))) {
            json_decref(list);
            return NULL;
        }
        json_array_append_new(list, value);
    }
    value = json_array_size(list) == 1 ? json_incref(json_array_get(list, 0)) : json_incref(list);
    json_decref(list);
    return value;
}

static json_t *printed_figures(const char *out)
{
    json_t *figures = json_object();
    char *text = xstrdup(out), *rest = text, *line;
    while ((line = strsep(&rest, "\n"))) {
        size_t key = strspn(line, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");
        if (key == 0 || (line[key] != ' ' && line[key] != '\t'))
            continue;
        json_t *value = values(line + key + 1);
        line[key] = '\0';
        if (value && !(json_is_array(value) && json_array_size(value) == 0))
            json_set(figures, line, value);
        else
            json_decref(value);
    }
    free(text);
    return figures;
}

struct outcome outcome_read(const char *out, const char *json_path, const char *required)
{
    struct outcome o = {0};
    json_error_t why;
    o.printed = printed_figures(out);
    o.run = json_load_file(json_path, 0, &why);
    if (!json_is_object(o.run))
        o.error = xasprintf("no figures from the simulator: %s", o.run ? "not a JSON object" : why.text);
    else if (required && isnan(outcome_figure(&o, required)))
        o.error = xasprintf("the program printed no line \"%s NUMBER\"", required);
    if (o.error) {
        json_decref(o.printed);
        json_decref(o.run);
        o.printed = o.run = NULL;
    }
    return o;
}

struct outcome outcome_of(const struct pool_job *job, const char *json_path, const char *required)
{
    struct outcome o = {0};
    if (job->state != POOL_DONE)
        o.error = xstrdup(job->error ? job->error : "not run");
    else if (job->cut)
        o.error = xstrdup(POOL_CUT);
    else
        o = outcome_read(job->out, json_path, required);
    o.wall_time_s = job->wall_time_s;
    return o;
}

void outcome_clear(struct outcome *o)
{
    json_decref(o->printed);
    json_decref(o->run);
    free(o->error);
    *o = (struct outcome){0};
}

double figure_of(const json_t *figures, const char *key)
{
    const json_t *value = json_object_get(figures, key);
    return json_is_number(value) ? json_number_value(value) : NAN;
}

double outcome_figure(const struct outcome *o, const char *key)
{
    return figure_of(o->printed, key);
}
