/* explore.c - see explore.h. */
#include "lab/explore/explore.h"
#include <stdlib.h>
#include <string.h>
#include "files/atomic_file.h"
#include "files/folder_make.h"
#include "kernel/hostclock.h"
#include "kernel/xalloc.h"
#include "lab/explore/run_verdict.h"
#include "lab/jobs/own_folder.h"
#include "files/words.h"

const char EXPLORE_TIMES_HINT[] =
    "Runs of one order have different outputs. If the program prints times, choose the lines that must be\n"
    "  equal with --same; else it looks at clocks, polls, or has a race of handlers.";

/* A run that takes so many times the base's virtual time, and so many seconds more, stands still. */
enum { TIMES_BASE = 10, SECONDS_MORE = 1 };

/* --- opening -------------------------------------------------------------------------------------------- */

/* In the folder for temporary files, where the runs' own folders are. */
static bool make_own_folders(struct explore *x, char **error)
{
    const struct subject_options *o = &x->options.subject;
    if (!(x->scratch = folder_scratch("touchstone-explore", error)).path)
        return false;
    x->own_folders = own_folder_place(x->scratch.path, x->subject->folder, o->program + !!o->program_count);
    if (!x->own_folders)
        *error = xasprintf("%s: folders for runs cannot be made: %m", x->scratch.path);
    return x->own_folders;
}

static bool open_folder(struct explore *x, char **error)
{
    struct batch_place *p = &x->place;
    char *runs = xasprintf("%s/runs", x->options.dir);
    bool made = folder_make(runs);
    if (!made)
        *error = xasprintf("%s cannot be made: %m", x->options.dir);
    made = made && subject_keep_input(x->subject, runs, error);
    free(runs);
    return made && (p->locks = point_locks_enter(x->options.dir, x->options.session, error)) &&
           (p->journal = journal_open(x->options.dir, x->options.notes, error)) && make_own_folders(x, error);
}

static void set_place(struct explore *x)
{
    const struct explore_options *o = &x->options;
    struct batch_place *p = &x->place;
    p->subject = x->subject;
    p->rules = &x->options.rules;
    p->dir = o->dir;
    p->scratch = x->own_folders;
    p->at_once = o->at_once;
    p->limit_s = o->limit_s;
    p->notes = o->notes;
    p->all = o->runs;
    p->begun_s = hostclock_s();
    p->deadline_s = o->seconds > 0 ? p->begun_s + o->seconds : 0;
    x->search = (struct search){.place = p, .draw = o->draw, .most = o->runs};
}

struct explore *explore_open(const struct explore_options *o, char **error)
{
    struct explore *x = xcalloc(1, sizeof *x);
    x->options = *o;
    if ((x->subject = subject_open(&o->subject, error)) && open_folder(x, error)) {
        set_place(x);
        return x;
    }
    explore_close(x);
    return NULL;
}

void explore_close(struct explore *x)
{
    if (!x)
        return;
    for (size_t i = 0; x->explained && i < x->search.outcome_count; i++) {
        free(x->explained[i].name);
        free(x->explained[i].first);
        delays_free(&x->explained[i].least.delays);
    }
    free(x->explained);
    search_free(&x->search);
    journal_close(x->place.journal);
    point_locks_leave(x->place.locks);
    scratch_remove(&x->scratch);
    free(x->own_folders);
    subject_close(x->subject);
    free(x);
}

/* --- the runs ------------------------------------------------------------------------------------------- */

static void free_runs(struct planned_run *runs, size_t count)
{
    for (size_t i = 0; i < count; i++)
        planned_run_free(&runs[i]);
    free(runs);
}

/* The base has to come to its end: all others are compared with it. */
static bool take_base(struct explore *x, const struct planned_run *base, char **error)
{
    if (!base->record) {
        *error =
            xasprintf("the run with the usual timing: %s", base->failure ? base->failure : "no time left");
        return false;
    }
    const char *message = json_string_value(json_object_get(base->record, "message"));
    if (message)
        fprintf(x->options.notes,
                "the run with the usual timing, with which all others are compared, fails: %.*s\n",
                (int)strcspn(message, "\n"), message); /* the report has the rest */
    if (verdict_lacks_file(base->record))
        fprintf(x->options.notes, "the run with the usual timing leaves no file %s: is that its name?\n",
                x->options.subject.compare_file);
    double seconds = json_number_value(json_object_get(base->record, "virtual_time_s"));
    subject_limit(x->subject, TIMES_BASE * seconds + SECONDS_MORE);
    return true;
}

/* Says so at once: the user may want to stop, and to choose the lines that must be equal. */
static void hint(struct explore *x)
{
    if (!x->hinted && x->search.times_differ)
        fprintf(x->options.notes, "  %s\n", EXPLORE_TIMES_HINT);
    x->hinted = x->search.times_differ;
}

/* Plans, runs and takes a round. False: it was the last one. */
static bool do_round(struct explore *x, char **error)
{
    struct planned_run *runs;
    bool is_base = !x->search.round;
    size_t count = search_round(&x->search, &runs);
    bool good = count && batch_do(&x->place, runs, count, error);
    if (good && is_base)
        good = take_base(x, runs, error);
    if (good)
        search_take(&x->search, runs, count);
    hint(x);
    for (size_t i = 0; i < count; i++)
        x->out_of_time |= !runs[i].record && !runs[i].failure;
    free_runs(runs, count);
    return good && !x->out_of_time;
}

/* --- outcomes ------------------------------------------------------------------------------------------- */

/* "deadlock-1" */
static char *name_of(const struct explore *x, size_t outcome)
{
    const struct outcome_group *g = x->search.outcomes;
    const char *end = json_string_value(json_object_get(g[outcome].record, "end"));
    size_t number = 1;
    for (size_t i = 1; i < outcome; i++)
        number += !strcmp(end, json_string_value(json_object_get(g[i].record, "end")));
    return xasprintf("%s-%zu", strcmp(end, "ended") ? end : "output", number);
}

static struct recording *recording_of(const struct explore *x, struct digest key)
{
    char *error = NULL, *path = batch_recording(&x->place, key);
    struct recording *r = recording_load(path, &error);
    free(error);
    free(path);
    return r;
}

static void find_divergence(const struct explore *x, struct explained *e, const struct explored *run)
{
    struct recording *base = recording_of(x, x->search.runs[0].key);
    struct recording *other = recording_of(x, e->least.repeats ? e->least.key : run->key);
    if (base && other) {
        struct divergence d = divergence_first(base, other);
        e->first = divergence_words(&d, base, other);
    }
    recording_free(base);
    recording_free(other);
}

char *explore_command(const struct explore *x, size_t outcome, const char *timing, const char *replay)
{
    const json_t *time = json_object_get(x->search.outcomes[outcome].record, "virtual_time_s");
    return subject_command_text(x->subject, timing, replay,
                                subject_is_limited(x->subject, json_number_value(time)));
}

/* The head of DIR/NAME.schedule: the outcome, the command, the delays in words. */
static char *comment_of(const struct explore *x, const struct explained *e, const char *path)
{
    char *command = explore_command(x, (size_t)(e - x->explained), NULL, path);
    char *text = xasprintf("# %s of the exploration %s\n# %s\n", e->name, x->options.dir, command);
    for (size_t i = 0; i < e->least.delays.count && i < 20; i++) {
        char *words = delay_words(&e->least.delays.list[i], x->search.base_nodes);
        words_append(&text, "# %s\n", words);
        free(words);
    }
    if (e->first)
        words_append(&text, "# first difference: %s\n", e->first);
    free(command);
    return text;
}

static bool write_schedule(const struct explore *x, const struct explained *e, char **error)
{
    char *path = xasprintf("%s/%s.schedule", x->options.dir, e->name), *comment = comment_of(x, e, path),
         *text = delays_text(&e->least.delays, x->search.base_nodes, comment);
    bool good = atomic_file_write(path, text, strlen(text), error);
    free(text);
    free(comment);
    free(path);
    return good;
}

/* Explains an outcome by the run that had the fewest delays. */
static bool explain(struct explore *x, size_t outcome, char **error)
{
    const struct outcome_group *g = &x->search.outcomes[outcome];
    const struct explored *run = &x->search.runs[g->least];
    struct explained *e = &x->explained[outcome];
    struct recording *r = run->recorded ? recording_of(x, run->key) : NULL;
    if (!r)
        return true;
    struct delay_bounds bounds = search_bounds(&x->search);
    bool good = least_find(&x->place, r, &bounds, g->group, x->options.tests, &e->least, error);
    recording_free(r);
    if (!good)
        return false;
    e->name = name_of(x, outcome);
    find_divergence(x, e, run);
    return write_schedule(x, e, error);
}

/* Many outcomes of one order are most often times that the program prints: of no output do the delays tell
 * anything then. A single one may be a race of a handler. */
static bool is_worth(const struct explore *x, size_t outcome)
{
    size_t alike = 0;
    for (size_t i = 1; i < x->search.outcome_count; i++)
        alike += x->search.outcomes[i].same_order;
    const char *end = json_string_value(json_object_get(x->search.outcomes[outcome].record, "end"));
    return alike < 2 || strcmp(end, "ended") != 0;
}

static bool explain_all(struct explore *x, char **error)
{
    size_t count = x->search.outcome_count;
    x->explained = xcalloc(count + 1, sizeof *x->explained);
    x->place.deadline_s = 0; /* the tests are limited by their number */
    for (size_t i = 1; i < count && i <= x->options.explained; i++)
        if (is_worth(x, i) && !explain(x, i, error))
            return false;
    return true;
}

bool explore_run(struct explore *x, char **error)
{
    *error = NULL;
    while (do_round(x, error))
        ;
    if (*error || x->place.signal)
        return false;
    x->made = x->place.run;
    x->before = x->place.before;
    x->wall_s = hostclock_s() - x->place.begun_s;
    return explain_all(x, error);
}

bool explore_usual_ended(const struct explore *x)
{
    return !strcmp(json_string_value(json_object_get(x->search.outcomes[0].record, "end")), "ended");
}

bool explore_reports(struct explore *x)
{
    return !*x->options.session || point_locks_take_report(x->place.locks);
}
