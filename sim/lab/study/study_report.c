/* study_report.c - writes the results and pictures of a study; see study.h. */
#include "files/json_set.h"
#include "lab/chart/chart.h"
#include "lab/chart/findings.h"
#include "lab/study/study_points.h"

#include <stdlib.h>

static bool each_of_study(void *arg, study_visit *visit, void *to, char **error)
{
    return study_each(arg, visit, to, error);
}

/* Draws a picture. A failure is printed on progress. */
static bool draw(const struct study *s, const struct record_points *points, const struct picture *picture)
{
    char *error = NULL;
    bool drawn = chart_draw(points, picture, s->options.dir, &error);
    if (!drawn)
        fprintf(s->options.progress, "no picture %s: %s\n", picture->file, error);
    free(error);
    return drawn;
}

/* Draws the pictures, and counts them in *drawn. False if there is no gnuplot for them, or the study names
 * them and not all are drawn: of standard ones, some may have nothing to show. */
static bool draw_all(const struct study *s, const struct record_points *points, const struct picture list[],
                     size_t count, size_t *drawn)
{
    char *error = NULL;
    *drawn = 0;
    if (count && !chart_can_draw(&error)) {
        fprintf(s->options.progress, "no pictures: %s (or write pictures = ( ); into the study file)\n",
                error);
        free(error);
        return false;
    }
    for (size_t i = 0; i < count; i++)
        *drawn += draw(s, points, &list[i]);
    return !s->spec->pictures || *drawn == count;
}

/* The header of the results, which names the baseline of the speed-ups. NULL with *error. */
static json_t *header_of(struct study *s, char **error)
{
    if (!study_find_baseline(s, error))
        return NULL;
    json_t *header = study_header(s);
    char *baseline = s->speedup ? speedup_baseline(s->speedup) : NULL;
    if (baseline && *baseline)
        json_set(header, "baseline", json_string(baseline));
    free(baseline);
    return header;
}

enum study_end study_report(struct study *s, char **error)
{
    struct record_points points = {each_of_study, s, header_of(s, error)};
    struct picture standard[CHART_STANDARD];
    const struct study_options *o = &s->options;
    size_t drawn = 0, pictures = s->spec->picture_count;
    const struct picture *list = s->spec->pictures;
    bool written = points.header && record_write_json(&points, o->dir, error) &&
                   record_write_csv(&points, o->dir, error);
    if (written && !list) {
        list = standard;
        pictures = chart_standard(&points, standard);
    }
    bool complete = written && draw_all(s, &points, list, pictures, &drawn);
    written = written && findings_write(&points, list, pictures, o->dir, error);
    json_decref(points.header);
    if (!written)
        return STUDY_ERROR;
    fprintf(o->out,
            "%zu point%s, %zu failed; %s has findings.md, results.json, results.csv and %zu picture%s\n",
            s->count, s->count == 1 ? "" : "s", s->counts.failed, o->dir, drawn, drawn == 1 ? "" : "s");
    return s->counts.failed || !complete ? STUDY_INCOMPLETE : STUDY_DONE;
}
