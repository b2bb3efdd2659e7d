/* time_profile_write.c - a profile as a table for people, and as JSON for programs: see time_profile.h. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "nx_api/contract/program_image.h"
#include "observe/json_file.h"
#include "observe/time_profile.h"

enum { PRINTED = 12 };

/* --- for people --- */

struct line {
    double seconds[PROFILE_CLASSES];
    const char *name;
};

static double percent(double part, vtime_sum whole)
{
    return whole ? 100 * part / vt_sum_seconds(whole) : 0;
}

/* The decimals of all seconds of the table: the whole time has five digits, as in touchstone profile. */
static int decimals(vtime_sum all)
{
    double seconds = vt_sum_seconds(all);
    return seconds > 0 && seconds < 1e4 ? 4 - (int)floor(log10(seconds)) : 0;
}

/* Prints the line's share of all nodes' time; if there are two classes, also of each class's time. */
static void print_line(const struct profile *p, FILE *f, const struct line *l)
{
    vtime_sum armed = profile_node_time(p, PROFILE_ARMED), others = profile_node_time(p, PROFILE_OTHERS);
    double seconds = l->seconds[PROFILE_ARMED] + l->seconds[PROFILE_OTHERS];
    fprintf(f, "%6.2f%%", percent(seconds, armed + others));
    if (armed && others)
        fprintf(f, " %8.2f%% %8.2f%%", percent(l->seconds[PROFILE_ARMED], armed),
                percent(l->seconds[PROFILE_OTHERS], others));
    fprintf(f, " %15.*f  %s", decimals(armed + others), seconds, l->name);
}

static void print_function(const struct profile *p, FILE *f, const struct profile_function *fn)
{
    char *name = fn->called ? xasprintf("%s called by %s", fn->called, fn->function) : xstrdup(fn->function);
    int length = (int)strlen(name);
    struct line l = {.name = name};
    for (int c = 0; c < PROFILE_CLASSES; c++)
        l.seconds[c] = profile_seconds(p, fn->units[c]);
    print_line(p, f, &l);
    if (*fn->file)
        fprintf(f, "%*s  %s:%" PRId64, length < 34 ? 34 - length : 0, "", fn->file, fn->line);
    fputc('\n', f);
    free(name);
}

static void print_more(const struct profile *p, FILE *f)
{
    char name[60];
    struct line l = {.name = name};
    if (p->function_count <= PRINTED)
        return;
    snprintf(name, sizeof name, "%zu more\n", p->function_count - PRINTED);
    for (size_t i = PRINTED; i < p->function_count; i++)
        for (int c = 0; c < PROFILE_CLASSES; c++)
            l.seconds[c] += profile_seconds(p, p->functions[i].units[c]);
    print_line(p, f, &l);
}

static void print_rest(const struct profile *p, FILE *f)
{
    struct line system = {.name = "(system)\n"}, idle = {.name = "(idle)\n"}, rest = {.name = "(ended)\n"};
    for (int c = 0; c < PROFILE_CLASSES; c++) {
        system.seconds[c] = vt_sum_seconds(p->times[c].system);
        idle.seconds[c] = vt_sum_seconds(p->times[c].idle);
        rest.seconds[c] = vt_sum_seconds(p->times[c].rest);
    }
    print_line(p, f, &system);
    print_line(p, f, &idle);
    print_line(p, f, &rest);
}

void profile_print(const struct profile *p, FILE *f)
{
    bool two = p->times[PROFILE_ARMED].nodes && p->times[PROFILE_OTHERS].nodes;
    fprintf(f, "\n%7s%s %15s  %-34s  %s\n", "share", two ? "  handlers    others" : "", "seconds", "function",
            "written at");
    for (size_t i = 0; i < p->function_count && i < PRINTED; i++)
        print_function(p, f, &p->functions[i]);
    print_more(p, f);
    print_rest(p, f);
}

/* --- for programs --- */

static const char *const CLASS[PROFILE_CLASSES] = {"others", "with_handlers"};

static json_t *function_json(const struct profile *p, const struct profile_function *fn)
{
    vtime_sum all = profile_node_time(p, PROFILE_ARMED) + profile_node_time(p, PROFILE_OTHERS);
    int64_t units = fn->units[PROFILE_ARMED] + fn->units[PROFILE_OTHERS];
    double seconds = profile_seconds(p, units);
    json_t *j = json_pack("{s:o, s:o, s:I, s:I, s:f, s:f}", "file", json_text(fn->file), "function",
                          json_text(fn->function), "line", (json_int_t)fn->line, "units", (json_int_t)units,
                          "seconds", seconds, "share", all ? seconds / vt_sum_seconds(all) : 0.0);
    if (fn->called)
        json_set(j, "called", json_text(fn->called));
    for (int c = 0; c < PROFILE_CLASSES; c++) {
        double part = profile_seconds(p, fn->units[c]);
        if (p->times[c].nodes && p->end)
            json_set(j, CLASS[c],
                     json_pack("{s:I, s:f, s:f}", "units", (json_int_t)fn->units[c], "seconds", part, "share",
                               part / vt_sum_seconds(profile_node_time(p, c))));
    }
    return j;
}

static json_t *idle_json(const struct profile *p, enum profile_class c)
{
    json_t *list = json_array();
    for (size_t i = 0; i < p->idle_count; i++)
        if (p->idle[i].waits[c])
            json_append(list, json_pack("{s:s, s:f, s:I}", "call", p->idle[i].call, "idle_s",
                                        vt_sum_seconds(p->idle[i].idle[c]), "waits",
                                        (json_int_t)p->idle[i].waits[c]));
    return list;
}

/* computing_s, system_s, idle_s and rest_s add up to node_time_s; tasks add up to system_s and beside_s. */
static json_t *class_json(const struct profile *p, enum profile_class c)
{
    const struct profile_times *t = &p->times[c];
    int64_t units = 0;
    double tasks[NODE_TASKS];
    for (int i = 0; i < NODE_TASKS; i++)
        tasks[i] = vt_sum_seconds(t->tasks[i]);
    for (size_t i = 0; i < p->function_count; i++)
        units += p->functions[i].units[c];
    return json_pack("{s:i, s:f, s:I, s:f, s:f, s:f, s:f, s:f, s:o, s:o}", "nodes", (int)t->nodes,
                     "node_time_s", vt_sum_seconds(profile_node_time(p, c)), "units", (json_int_t)units,
                     "computing_s", vt_sum_seconds(t->computing), "system_s", vt_sum_seconds(t->system),
                     "idle_s", vt_sum_seconds(t->idle), "rest_s", vt_sum_seconds(t->rest), "beside_s",
                     vt_sum_seconds(t->beside), "tasks", json_tasks(tasks), "waits", idle_json(p, c));
}

char *profile_json(const struct profile *p, const struct machine *m, const char *path)
{
    char digest[17];
    snprintf(digest, sizeof digest, "%016" PRIx64, m->sys.digest);
    json_t *functions = json_array(), *classes = json_object();
    for (size_t i = 0; i < p->function_count; i++)
        json_append(functions, function_json(p, &p->functions[i]));
    for (int c = 0; c < PROFILE_CLASSES; c++)
        if (p->times[c].nodes)
            json_set(classes, CLASS[c], class_json(p, c));
    json_t *root = json_pack(
        "{s:s, s:o, s:o, s:o, s:i, s:f, s:s, s:i, s:I, s:o, s:o, s:I, s:o}", "format", "touchstone profile 1",
        "program", json_text(m->options.programs[0].argv[0]), "arguments",
        json_texts(m->options.programs[0].argv + 1), "machine", json_text(m->sys.cfg->name), "nodes",
        (int)m->sys.count, "virtual_time_s", vt_seconds(p->end), "digest", digest, "units_per_clock",
        NXC_UNITS_PER_CLOCK, "units_per_second", (json_int_t)p->units_per_second, "classes", classes,
        "functions", functions, "end_ps", (json_int_t)p->end, "tree", call_tree_json(&p->tree));
    return json_file_write(root, path);
}
