/* study_make.c - see study_make.h. */
#include "lab/study/study_make.h"
#include "lab/study/study_parts.h"

#include <stdlib.h>

/* A point that failed in an earlier session has no line of progress, and is named here. */
static void tell_failed_before(const struct study *s)
{
    for (size_t i = 0; i < s->count; i++) {
        enum journal_line_state state;
        struct point p;
        char *error = NULL;
        if (!journal_find(s->journal, s->work[i].key, &state) || state != LINE_FAILED)
            continue;
        json_t *record = point_make(s->spec, s->work[i].number, &p, &error) == POINT_WANTED
                             ? journal_record(s->journal, s->work[i].key)
                             : NULL;
        if (record) {
            char *name = point_name(s->spec, &p);
            fprintf(s->options.progress, "failed before: %s: %s\n", name,
                    json_string_value(json_object_get(record, "failure")));
            free(name);
        }
        json_decref(record);
        free(error);
    }
}

/* Prints where the results came from. A process of a session knows only its own runs. */
static void tell(const struct study *s)
{
    const struct study_options *o = &s->options;
    const struct study_counts *c = &s->counts;
    if (*o->session)
        fprintf(o->out, "%zu of %zu points run by this process, %zu in %s/journal before", c->run, s->count,
                c->before, o->dir);
    else
        fprintf(o->out, "%zu point%s run, %zu in %s/journal before", c->run, c->run == 1 ? "" : "s",
                c->before, o->dir);
    if (o->cache)
        fprintf(o->out, ", %zu from the cache", c->cached);
    fputc('\n', o->out); /* how many failed is said by study_report() */
}

enum study_end study_make(const struct study_options *options, int *signal, char **error)
{
    struct study *s = study_open(options, error);
    if (s)
        tell_failed_before(s);
    enum study_end end = s ? study_run(s, error) : STUDY_ERROR;
    *signal = s ? s->counts.signal : 0;
    if (end == STUDY_STOPPED) {
        size_t have = s->counts.run + s->counts.before + s->counts.cached;
        fprintf(options->progress,
                "stopped: %zu of %zu points are in %s/journal; the same command goes on from there\n", have,
                s->count, options->dir);
    } else if (end == STUDY_DONE && point_locks_take_report(s->locks)) {
        tell(s);
        end = study_report(s, error);
    }
    study_close(s);
    return end;
}
