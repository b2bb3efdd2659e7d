/* runs_journal.c - see runs_journal.h. */
#include "lab/tables/runs_journal.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/jobs/journal.h"
#include "lab/jobs/point_locks.h"
#include "lab/study/inputs.h"

#include <stdlib.h>
#include <string.h>

struct runs_journal {
    struct point_locks *locks;
    struct journal *journal;
    json_t *shared; /* inputs of all runs */
    FILE *notes;
};

static bool read_shared(struct runs_journal *k, const struct tables_options *o, const struct paper *paper,
                        char **error)
{
    char *program = xasprintf("%s/%s", o->programs, paper->program);
    char *machine = strchr(paper->machine, '/') ? xstrdup(paper->machine)
                                                : xasprintf("%s/machines/%s.cfg", o->home, paper->machine);
    struct digest d;
    bool ok = digest_set_file(k->shared, "touchstone", o->runner, error) &&
              digest_set_file(k->shared, "program", program, error);
    if (ok && !(ok = inputs_machine_file(machine, &d)))
        *error = xasprintf("%s cannot be read: %m", machine);
    if (ok)
        json_set(k->shared, "machine", digest_json(d));
    free(program);
    free(machine);
    return ok;
}

struct runs_journal *runs_journal_open(const struct tables_options *o, const struct paper *paper,
                                       char **error)
{
    struct runs_journal *k = xcalloc(1, sizeof *k);
    *k = (struct runs_journal){.shared = json_object(), .notes = o->progress};
    if (read_shared(k, o, paper, error) && (k->locks = point_locks_enter(o->dir, "", error)) &&
        (k->journal = journal_open(o->dir, o->progress, error)))
        return k;
    runs_journal_close(k);
    return NULL;
}

void runs_journal_close(struct runs_journal *k)
{
    if (!k)
        return;
    journal_close(k->journal);
    point_locks_leave(k->locks);
    json_decref(k->shared);
    free(k);
}

static struct digest key_of(const struct runs_journal *k, const struct run *run)
{
    json_t *inputs = json_copy(k->shared);
    json_set(inputs, "nodes", json_integer(run->nodes));
    json_set(inputs, "arguments", json_string(run->arguments));
    json_set(inputs, "extra", json_string_or_null(run->extra));
    json_set(inputs, "settings", json_texts(run->settings));
    struct digest key = digest_of_json(inputs);
    json_decref(inputs);
    return key;
}

bool runs_journal_find(struct runs_journal *k, struct run *run)
{
    json_t *record = journal_record(k->journal, key_of(k, run));
    json_t *printed = json_object_get(record, "printed"), *figures = json_object_get(record, "run");
    bool found = printed && figures;
    if (found)
        run->outcome =
            (struct outcome){.printed = json_incref(printed),
                             .run = json_incref(figures),
                             .wall_time_s = json_number_value(json_object_get(record, "wall_time_s"))};
    json_decref(record);
    return found;
}

void runs_journal_add(struct runs_journal *k, const struct run *run)
{
    char *error = NULL;
    json_t *record =
        xchecked(json_pack("{s:s, s:O, s:O, s:f}", "name", run->name, "printed", run->outcome.printed, "run",
                           run->outcome.run, "wall_time_s", run->outcome.wall_time_s));
    if (!journal_add(k->journal, key_of(k, run), LINE_DONE, record, true, &error))
        fprintf(k->notes, "not in the journal: %s\n", error);
    free(error);
    json_decref(record);
}
