/* point_run.c - see point_run.h. */
#include "lab/study/point_run.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "files/words.h"
#include "lab/study/point_figures.h"

char **point_run_argv(const struct spec *spec, const struct inputs *inputs, const struct point *p,
                      const struct point_run_files *files)
{
    char **argv = NULL, **set = inputs_settings(inputs, p), **arguments = inputs_arguments(inputs, p);
    words_add_each(&argv, NULL, (const char *const[]){files->runner, "run", "-q", NULL});
    words_add_option(&argv, "-m", xstrdup(point_machine(spec, p)));
    words_add_option(&argv, "-n", xasprintf("%lu", point_nodes(spec, p)));
    words_add_option(&argv, "--json", xstrdup(files->json));
    if (files->profile)
        words_add_option(&argv, "--profile", xstrdup(files->profile));
    if (spec->max_virtual_s > 0)
        words_add_option(&argv, "--max-virtual-time", xasprintf("%.15g", spec->max_virtual_s));
    if (spec->max_wall_s > 0)
        words_add_option(&argv, "--max-wall-time", xasprintf("%.15g", spec->max_wall_s));
    if (spec->max_unreceived_mb)
        words_add_option(&argv, "--max-unreceived", xasprintf("%" PRIu64, spec->max_unreceived_mb));
    words_add_each(&argv, "--set", (const char *const *)set);
    for (const char **input = spec->inputs; *input; input++)
        words_add_option(&argv, "--host-files", xasprintf("%s:ro", *input));
    words_add(&argv, xstrdup(files->program));
    words_add_each(&argv, NULL, (const char *const *)arguments);
    words_free(set);
    words_free(arguments);
    return argv;
}

/* TMPDIR is the scratch folder: the simulated machine's files are removed with it at the latest. Of the rest
 * of the environment a run gets only what it needs, since results must not depend on it. */
char **point_run_environment(const char *scratch)
{
    static const char *const passed[] = {
        "PATH", "HOME", "TOUCHSTONE_HOME", "LD_LIBRARY_PATH", "ASAN_OPTIONS", "TOUCHSTONE_HOST_FILES"};
    char **env = NULL;
    words_add(&env, xasprintf("TMPDIR=%s", scratch));
    for (size_t i = 0; i < sizeof passed / sizeof *passed; i++)
        if (getenv(passed[i]))
            words_add(&env, xasprintf("%s=%s", passed[i], getenv(passed[i])));
    return env;
}

json_t *point_record(const struct outcome *o, const char *profile, double wall_time_s)
{
    /* paths of this run, and what is equal for all that went well */
    static const char *const left_out[] = {"program", "host_files", "outcome"};
    json_t *figures = point_figures_of(o);
    for (size_t i = 0; i < sizeof left_out / sizeof *left_out; i++)
        json_object_del(figures, left_out[i]);
    json_t *record = json_pack("{s:f, s:o}", "wall_time_s", wall_time_s, "figures", figures);
    json_t *by_function = profile ? json_load_file(profile, 0, NULL) : NULL;
    if (by_function) {
        json_object_del(by_function, "tree"); /* it is large, and a study compares functions */
        json_set(record, "profile", by_function);
    }
    return record;
}

json_t *point_record_of_failure(const char *error, double wall_time_s)
{
    return json_pack("{s:f, s:o}", "wall_time_s", wall_time_s, "failure", json_text(error));
}

/* The total time that the program printed, or else the run's virtual time. */
static double time_of(const json_t *figures)
{
    double total = figure_of(figures, "total_s");
    return isnan(total) ? figure_of(figures, "virtual_time_s") : total;
}

json_t *point_flat(json_t *values, const json_t *record)
{
    json_t *failure = json_object_get(record, "failure"), *figures = json_object_get(record, "figures"),
           *wall = json_object_get(record, "wall_time_s");
    json_set(values, "failure", failure ? json_incref(failure) : json_null());
    if (wall)
        json_set(values, "wall_time_s", json_incref(wall));
    if (figures && json_object_update_missing(values, figures) != 0)
        xexhausted();
    double time = time_of(values);
    if (!isnan(time) && !json_object_get(values, "time_s"))
        json_set(values, "time_s", json_real(time));
    return values;
}
