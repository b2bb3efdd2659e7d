/* baseline_point.c - see baseline_point.h. */
#include "lab/check/baseline_point.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/jobs/outcome.h"
#include "files/words.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The value as its 15 digits in a file will be read back: a point from a run and the same point from a file
 * compare as equal. */
static double as_written(double value)
{
    char text[32];
    snprintf(text, sizeof text, "%.15g", value);
    return strtod(text, NULL);
}

/* Adds seconds to the number of that key, which starts at 0. Sums of 0 are left out. */
static void add(json_t *to, const char *key, double seconds)
{
    double sum = json_number_value(json_object_get(to, key)) + seconds;
    if (sum != 0)
        json_set(to, key, json_real(as_written(sum)));
}

/* --- figures -------------------------------------------------------------------------------------------- */

static bool begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

/* Is this a figure? Means of classes are in `where`; the keys listed here tell what was run. */
static bool is_kept(const char *key)
{
    static const char *const no[] = {"program",    "machine", "nodes",   "arguments", "settings",
                                     "host_files", "outcome", "failure", "profile"};
    for (size_t i = 0; i < sizeof no / sizeof *no; i++)
        if (strcmp(key, no[i]) == 0)
            return false;
    return !strstr(key, "wall_time") && !begins(key, "handlers.") && !begins(key, "others.");
}

/* The figure as it will be read back from the file; NULL if the value is no figure. */
static json_t *figure(const json_t *value)
{
    if (json_is_real(value))
        return json_real(as_written(json_real_value(value)));
    if (json_is_array(value)) {
        json_t *list = json_array();
        for (size_t i = 0; i < json_array_size(value); i++)
            if (json_array_append_new(list, figure(json_array_get(value, i))) != 0)
                return json_decref(list), NULL;
        return list;
    }
    return json_is_integer(value) || json_is_string(value) ? json_copy((json_t *)value) : NULL;
}

/* Figures of the machine's file system are left out if they are 0. */
static bool is_unused(const char *key, const json_t *value)
{
    return begins(key, "files.") && json_is_number(value) && json_number_value(value) == 0;
}

/* Does time_s only repeat total_s or virtual_time_s (study.h)? */
static bool is_twice(const json_t *figures)
{
    double time = figure_of(figures, "time_s");
    return time == figure_of(figures, "total_s") || time == figure_of(figures, "virtual_time_s");
}

static json_t *figures_kept(const json_t *figures, const json_t *axes)
{
    json_t *kept = json_object(), *value, *copy;
    const char *key;
    json_object_foreach((json_t *)figures, key, value) if (!json_object_get(axes, key) && is_kept(key) &&
                                                           !is_unused(key, value) && (copy = figure(value)))
        json_set(kept, key, copy);
    if (is_twice(figures))
        json_object_del(kept, "time_s");
    return kept;
}

/* --- where the time went: by a profile ------------------------------------------------------------------ */

/* A name that does not change with line numbers or the folder of compilation. */
static char *function_name(const json_t *function)
{
    const char *name = json_string_value(json_object_get(function, "function")),
               *file = json_string_value(json_object_get(function, "file")),
               *called = json_string_value(json_object_get(function, "called"));
    file = file ? basename(file) : "";
    return xasprintf("%s%s%s%s%s%s", called ? called : "", called ? " called by " : "", name ? name : "?",
                     *file ? " (" : "", file, *file ? ")" : "");
}

static json_t *functions_of(const json_t *profile, const char *class)
{
    json_t *to = json_object(), *function;
    size_t i;
    json_array_foreach(json_object_get(profile, "functions"), i, function)
    {
        char *name = function_name(function);
        add(to, name, figure_of(json_object_get(function, class), "seconds"));
        free(name);
    }
    return to;
}

/* The system's seconds by task: "copying" for copying_s. */
static json_t *tasks_of(const json_t *class)
{
    json_t *to = json_object(), *seconds;
    const char *key;
    json_object_foreach(json_object_get(class, "tasks"), key, seconds)
    {
        size_t length = strlen(key);
        char *task = xasprintf("%.*s", (int)(length > 2 ? length - 2 : length), key);
        add(to, task, json_number_value(seconds));
        free(task);
    }
    return to;
}

static json_t *waits_of(const json_t *class)
{
    json_t *to = json_object(), *wait;
    size_t i;
    json_array_foreach(json_object_get(class, "waits"), i, wait)
    {
        const char *call = json_string_value(json_object_get(wait, "call"));
        add(to, call ? call : "other", figure_of(wait, "idle_s"));
    }
    return to;
}

static json_t *where_of_profile(const json_t *profile)
{
    json_t *where = json_object(), *class;
    const char *name;
    json_object_foreach(json_object_get(profile, "classes"), name, class)
    {
        json_t *to = json_object();
        json_set(to, "nodes", json_incref(json_object_get(class, "nodes")));
        json_set(to, "functions", functions_of(profile, name));
        json_set(to, "system", tasks_of(class));
        json_set(to, "idle", waits_of(class));
        add(to, "ended", json_number_value(json_object_get(class, "rest_s")));
        json_set(where, name, to);
    }
    return where;
}

/* --- the same, without one ------------------------------------------------------------------------------ */

/* `where` of a class from the means of its nodes. The figures waits.KIND_s are parts of idle_s. */
static json_t *where_of_class(const json_t *figures, const char *prefix, double nodes)
{
    json_t *to = json_object(), *functions = json_object(), *system = json_object(), *idle = json_object();
    json_t *value;
    const char *key;
    json_set(to, "nodes", json_integer((json_int_t)nodes));
    json_object_foreach((json_t *)figures, key, value)
    {
        double seconds = nodes * json_number_value(value);
        if (!begins(key, prefix))
            continue;
        const char *time = key + strlen(prefix);
        if (strcmp(time, "busy_s") == 0)
            add(functions, "all of the program", seconds);
        else if (strcmp(time, "system_s") == 0)
            add(system, "all tasks", seconds);
        else if (begins(time, "waits.")) {
            char *wait = xasprintf("%.*s", (int)(strlen(time) - strlen("waits._s")), time + strlen("waits."));
            add(idle, wait, seconds);
            free(wait);
        }
    }
    json_set(to, "functions", functions);
    json_set(to, "system", system);
    json_set(to, "idle", idle);
    return to;
}

static json_t *where_of_figures(const json_t *figures)
{
    static const char *const classes[][2] = {{"others", "others."}, {"with_handlers", "handlers."}};
    json_t *where = json_object();
    for (size_t i = 0; i < 2; i++) {
        char *key = xasprintf("%snodes", classes[i][1]);
        double nodes = figure_of(figures, key);
        if (nodes > 0)
            json_set(where, classes[i][0], where_of_class(figures, classes[i][1], nodes));
        free(key);
    }
    return where;
}

json_t *baseline_point(const json_t *point, const json_t *axes)
{
    json_t *kept = json_object(), *profile = json_object_get(point, "profile");
    json_t *where = json_is_object(profile) ? where_of_profile(profile) : where_of_figures(point);
    json_set(kept, "figures", figures_kept(point, axes));
    if (json_object_size(where))
        json_set(kept, "where", where);
    else
        json_decref(where);
    return kept;
}

char *baseline_name(const json_t *point, const json_t *axes)
{
    char *name = xstrdup("");
    const char *axis;
    json_t *values;
    json_object_foreach((json_t *)axes, axis, values)
    {
        const json_t *value = json_object_get(point, axis);
        words_append(&name, "%s%s ", *name ? ", " : "", axis);
        if (json_is_string(value))
            words_append(&name, "%s", json_string_value(value));
        else
            words_append(&name, "%.15g", json_number_value(value));
    }
    if (*name)
        return name;
    free(name);
    return xasprintf("the run");
}
