/* compare_gate.c - see compare_gate.h. */
#include "lab/check/compare_gate.h"
#include "files/atomic_file.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/chart/record.h"
#include "lab/check/baseline.h"
#include "lab/check/baseline_point.h"
#include "lab/check/compare_export.h"
#include "lab/check/compare_print.h"
#include "lab/check/compiler.h"
#include "lab/check/junit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST_TOLD = 20 }; /* points printed in full; the others are printed in a line each */

struct gate {
    const struct gate_options *options;
    json_t *baseline; /* as read */
    json_t *update;   /* the new baseline; NULL without --update */
    json_t *figures;  /* an object with all figures that points have */
    struct compare_point **points;
    size_t count;
    json_t *compilers; /* STUDY: the compiler of its program now */
};

/* A study while its points are compared. */
struct visit {
    struct gate *gate;
    const char *study;
    const json_t *axes, *before;
    json_t *seen; /* names of the points compared so far */
};

/* --- comparing ------------------------------------------------------------------------------------------ */

static void keep(struct gate *g, struct compare_point *p)
{
    g->points = xrealloc(g->points, (g->count + 1) * sizeof *g->points);
    p->order = g->count;
    g->points[g->count++] = p;
}

static bool visit_point(void *arg, const json_t *flat, char **error)
{
    struct visit *v = arg;
    const char *failure = json_string_value(json_object_get(flat, "failure"));
    char *name = baseline_name(flat, v->axes);
    json_t *point = failure ? NULL : baseline_point(flat, v->axes);
    (void)error;
    json_object_update(v->gate->figures, json_object_get(point, "figures"));
    keep(v->gate, compare_point(v->study, name, json_object_get(v->before, name), point, failure,
                                &v->gate->options->rules));
    json_set(v->seen, name, json_null());
    if (v->gate->update && point)
        json_set(baseline_study(v->gate->update, v->study), name, json_incref(point));
    json_decref(point);
    free(name);
    return true;
}

static void find_missing(struct visit *v)
{
    const char *name;
    json_t *point;
    json_object_foreach((json_t *)v->before, name, point) if (!json_object_get(v->seen, name))
        keep(v->gate, compare_point(v->study, name, point, NULL, NULL, &v->gate->options->rules));
}

static bool compare_study(struct gate *g, struct study *s, const char *name, char **error)
{
    json_t *header = study_header(s);
    struct visit v = {.gate = g,
                      .study = name,
                      .axes = json_object_get(header, "axes"),
                      .before = baseline_find(g->baseline, name),
                      .seen = json_object()};
    char *compiler = compiler_of(study_program(s));
    if (compiler)
        json_set(g->compilers, name, json_string(compiler));
    if (g->update) {
        json_object_clear(baseline_study(g->update, name));
        baseline_set_compiler(g->update, name, compiler);
    }
    free(compiler);
    bool good = study_each(s, visit_point, &v, error);
    if (good)
        find_missing(&v);
    json_decref(v.seen);
    json_decref(header);
    return good;
}

/* --- running -------------------------------------------------------------------------------------------- */

static char *study_name(const char *file)
{
    const char *name = basename(file), *dot = strrchr(name, '.');
    return xasprintf("%.*s", (int)(dot && dot > name ? (size_t)(dot - name) : strlen(name)), name);
}

static bool run_study(struct gate *g, const char *file, const char *name, char **error)
{
    struct study_options o = g->options->study;
    char *dir = xasprintf("%s/%s", g->options->dir, name);
    o.file = file;
    o.dir = dir;
    struct study *s = study_open(&o, error);
    enum study_end end = s ? study_run(s, error) : STUDY_ERROR;
    if (end == STUDY_STOPPED)
        *error = xasprintf("stopped by a signal; the same command goes on from here");
    bool good = (end == STUDY_DONE || end == STUDY_INCOMPLETE) && compare_study(g, s, name, error);
    study_close(s);
    free(dir);
    return good;
}

/* Without --update the baseline must have the study: a misspelt name would pass as a study of new points. */
static bool is_known(const struct gate *g, const char *file, const char *name, char **error)
{
    for (const char *const *other = g->options->files; *other != file; other++) {
        char *its = study_name(*other);
        bool same = strcmp(its, name) == 0;
        free(its);
        if (same) {
            *error = xasprintf("%s and %s would both be \"%s\" in the baseline", *other, file, name);
            return false;
        }
    }
    if (g->update || baseline_find(g->baseline, name))
        return true;
    *error = xasprintf("%s has no study \"%s\"; --update adds it", g->options->baseline, name);
    return false;
}

static bool run_all(struct gate *g, char **error)
{
    bool good = true;
    for (const char *const *file = g->options->files; good && *file; file++) {
        char *name = study_name(*file);
        good = is_known(g, *file, name, error) && run_study(g, *file, name, error);
        free(name);
    }
    return good;
}

/* --- telling -------------------------------------------------------------------------------------------- */

/* By how much the point's gravest figure changed. */
static double change_of(const struct compare_point *p)
{
    return p->figure_count && !isnan(p->figures[0].change_pct) ? fabs(p->figures[0].change_pct) : 0;
}

/* Sorts the worst first: by verdict, then by the change. */
static int worst_first(const void *a, const void *b)
{
    const struct compare_point *const *x = a, *const *y = b;
    double p = change_of(*x), q = change_of(*y);
    if ((*x)->verdict != (*y)->verdict)
        return (*x)->verdict < (*y)->verdict ? 1 : -1;
    return p != q ? (p < q ? 1 : -1) : (*x)->order < (*y)->order ? -1 : 1;
}

static struct compare_point **sort_worst_first(const struct gate *g)
{
    struct compare_point **sorted = xcalloc(g->count + 1, sizeof *sorted);
    memcpy(sorted, g->points, g->count * sizeof *sorted);
    qsort(sorted, g->count, sizeof *sorted, worst_first);
    return sorted;
}

/* In full; of one figure, or of many points, in a line each. */
static void print_all(const struct gate *g, struct compare_point *const sorted[], FILE *out)
{
    for (size_t i = 0; i < g->count && sorted[i]->verdict != COMPARE_SAME; i++)
        if (i < MOST_TOLD && !g->options->rules.only)
            compare_print(sorted[i], out);
        else
            compare_print_short(sorted[i], out);
}

static bool all_same(const struct gate *g, const char *study)
{
    for (size_t i = 0; i < g->count; i++)
        if (!strcmp(g->points[i]->study, study) && g->points[i]->verdict != COMPARE_SAME)
            return false;
    return true;
}

/* Studies that differ, perhaps for no other reason than that another compiler has made their program. */
static void print_compilers(const struct gate *g, FILE *out)
{
    const char *study;
    json_t *value;
    json_object_foreach(g->compilers, study, value)
    {
        const char *before = baseline_compiler(g->baseline, study), *now = json_string_value(value);
        if (before && strcmp(before, now) != 0 && !all_same(g, study))
            fprintf(out,
                    "%s: the program of the baseline was compiled by %s, this one by %s; versions of GCC "
                    "optimise differently, which alone changes costs\n",
                    study, before, now);
    }
}

static void print_counts(const struct gate *g, FILE *out)
{
    static const char *const words[COMPARE_FAILED + 1] = {
        "the same", "with differences that decide nothing", "better", "new", "worse", "missing", "failed"};
    size_t count[COMPARE_FAILED + 1] = {0};
    for (size_t i = 0; i < g->count; i++)
        count[g->points[i]->verdict]++;
    fprintf(out, "%zu point%s", g->count, g->count == 1 ? "" : "s");
    const char *mark = ":";
    for (int v = COMPARE_SAME; v <= COMPARE_FAILED; v++, mark = count[v - 1] ? "," : mark)
        if (count[v])
            fprintf(out, "%s %zu %s", mark, count[v], words[v]);
    fputc('\n', out);
    if (!g->update && !count[COMPARE_FAILED] && count[COMPARE_SAME] < g->count)
        fputs("to make this the baseline, give the same command with --update\n", out);
}

/* Writes the points into a file, if there is to be one. */
static bool write_file(const struct gate *g, const char *path,
                       void (*write)(struct compare_point *const points[], size_t count, FILE *out),
                       char **error)
{
    struct atomic_file d;
    if (!path)
        return true;
    if (!atomic_file_begin(&d, path, error))
        return false;
    write(g->points, g->count, d.out);
    return atomic_file_end(&d, error);
}

/* --- the whole ------------------------------------------------------------------------------------------ */

static bool open_baseline(struct gate *g, char **error)
{
    const char *path = g->options->baseline;
    if (g->options->update && access(path, F_OK) != 0)
        g->baseline = baseline_new();
    else if (access(path, F_OK) != 0)
        *error = xasprintf("%s: %m; --update makes a baseline", path);
    else
        g->baseline = baseline_read(path, error);
    if (g->baseline && g->options->update)
        g->update = json_deep_copy(g->baseline);
    return g->baseline;
}

static size_t failures(const struct gate *g, enum compare_verdict from)
{
    size_t count = 0;
    for (size_t i = 0; i < g->count; i++)
        count += g->points[i]->verdict >= from;
    return count;
}

/* A figure that no point has is a mistake. */
static bool check_rules(const struct gate *g, char **error)
{
    const char *unused = compare_rules_unused(&g->options->rules, g->figures);
    if (!unused)
        return true;
    char *figures = json_keys_text(g->figures, NULL), *meant = record_key_meant(g->figures, unused);
    *error = xasprintf("%s %s: no point has a figure of that name; %s %s",
                       unused == g->options->rules.only ? "--only" : "--tolerance", unused, meant, figures);
    free(figures);
    free(meant);
    return false;
}

static enum gate_end finish(struct gate *g, char **error)
{
    FILE *out = g->options->study.out;
    if (!check_rules(g, error))
        return GATE_ERROR;
    struct compare_point **sorted = sort_worst_first(g);
    print_all(g, sorted, out);
    print_compilers(g, out);
    print_counts(g, out);
    if (g->options->github) /* GitHub shows the first ten of a step */
        compare_write_github(sorted, g->count, out);
    free(sorted);
    fflush(out);
    if (!write_file(g, g->options->junit, junit_write, error) ||
        !write_file(g, g->options->json, compare_write_json, error))
        return GATE_ERROR;
    if (!g->update)
        return failures(g, COMPARE_WORSE) ? GATE_WORSE : GATE_PASSED;
    if (failures(g, COMPARE_FAILED)) {
        *error = xasprintf("%s is as it was: points failed", g->options->baseline);
        return GATE_ERROR;
    }
    return baseline_write(g->update, g->options->baseline, error) ? GATE_PASSED : GATE_ERROR;
}

enum gate_end gate_run(const struct gate_options *options, char **error)
{
    struct gate g = {.options = options, .figures = json_object(), .compilers = json_object()};
    enum gate_end end = GATE_ERROR;
    if (open_baseline(&g, error) && run_all(&g, error))
        end = finish(&g, error);
    for (size_t i = 0; i < g.count; i++)
        compare_free(g.points[i]);
    free(g.points);
    json_decref(g.baseline);
    json_decref(g.update);
    json_decref(g.compilers);
    json_decref(g.figures);
    return end;
}
