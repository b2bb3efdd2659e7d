/* live_study.c - see live_study.h. */
#include "lab/serve/live_study.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/jobs/journal.h"
#include "lab/jobs/point_locks.h"
#include "lab/page/page_item.h"
#include "lab/serve/merged_points.h"
#include "lab/study/study_note.h"

static const char ADDED[] = "added", RESULTS[] = "results.json", JOURNAL[] = "journal";

/* --- opening -------------------------------------------------------------------------------------------- */

static bool has(int folder, const char *name)
{
    int file = study_folder_file(folder, name);
    if (file >= 0)
        close(file);
    return file >= 0;
}

/* A study that has just begun has only its lock and journal. The paper's tables have those, too. */
bool live_study_is(const char *dir)
{
    int folder = study_folder_open(AT_FDCWD, dir, false);
    bool is = folder >= 0 && (has(folder, STUDY_NOTE_NAME) || has(folder, RESULTS) ||
                              (has(folder, "lock") && !has(folder, "tables.json")));
    if (folder >= 0)
        close(folder);
    return is;
}

struct live_study *live_study_open(const char *dir, char **error)
{
    int folder = study_folder_open(AT_FDCWD, dir, false);
    if (folder < 0)
        return *error = xasprintf("%s: %s", dir, strerror(errno)), NULL;
    struct live_study *s = xcalloc(1, sizeof *s);
    *s = (struct live_study){.name = xstrdup(dir),
                             .folder = folder,
                             .added = -1,
                             .note_file.name = STUDY_NOTE_NAME,
                             .journal_file.name = JOURNAL,
                             .results_file.name = RESULTS,
                             .added_file.name = JOURNAL};
    journal_points_init(&s->own);
    journal_points_init(&s->more);
    live_study_look(s);
    return s;
}

void live_study_close(struct live_study *s)
{
    journal_points_free(&s->own);
    journal_points_free(&s->more);
    json_decref(s->note);
    json_decref(s->results);
    if (s->added >= 0)
        close(s->added);
    close(s->folder);
    free(s->name);
    free(s);
}

/* --- looking -------------------------------------------------------------------------------------------- */

static void read_journal(struct journal_points *j, int folder, uint64_t from)
{
    int fd = study_folder_file(folder, JOURNAL);
    journal_points_read(j, fd, from);
    if (fd >= 0)
        close(fd);
}

static uint64_t number(const json_t *note, const char *key)
{
    json_int_t value = json_integer_value(json_object_get(note, key));
    return value > 0 ? (uint64_t)value : 0;
}

static void read_note(struct live_study *s)
{
    json_decref(s->note);
    s->note = study_folder_json(s->folder, STUDY_NOTE_NAME);
    if (s->note && (!json_is_object(json_object_get(json_object_get(s->note, "header"), "axes")) ||
                    !json_is_string(json_object_get(s->note, "study")) ||
                    !json_is_string(json_object_get(s->note, "program")))) {
        json_decref(s->note);
        s->note = NULL;
    }
    journal_points_free(&s->own); /* lines are counted anew */
    journal_points_init(&s->own);
}

static void read_results(struct live_study *s)
{
    json_decref(s->results);
    s->results = study_folder_json(s->folder, RESULTS);
    if (s->results && json_is_array(json_object_get(s->results, "points")) &&
        json_is_object(json_object_get(s->results, "axes"))) {
        s->results = page_json_within_53_bits(s->results);
        return;
    }
    json_decref(s->results);
    s->results = NULL;
}

void live_study_look(struct live_study *s)
{
    bool note = watched_file_changed(&s->note_file, s->folder),
         journal = watched_file_changed(&s->journal_file, s->folder),
         results = watched_file_changed(&s->results_file, s->folder), running = s->running;
    if (s->added < 0)
        s->added = study_folder_open(s->folder, ADDED, false);
    bool added = s->added >= 0 && watched_file_changed(&s->added_file, s->added);
    if (note)
        read_note(s);
    if (note || journal)
        read_journal(&s->own, s->folder, number(s->note, "journal_from"));
    if (results)
        read_results(s);
    if (added)
        read_journal(&s->more, s->added, 0);
    s->running = point_locks_are_held(s->folder);
    s->version += note || journal || results || added || s->running != running;
}

/* --- showing -------------------------------------------------------------------------------------------- */

/* A study writes its results behind the last line of its journal. */
static bool is_complete(const struct live_study *s)
{
    const struct timespec *journal = &s->journal_file.seen.st_mtim, *results = &s->results_file.seen.st_mtim;
    return s->results && (!s->note || results->tv_sec > journal->tv_sec ||
                          (results->tv_sec == journal->tv_sec && results->tv_nsec >= journal->tv_nsec));
}

static size_t failures(const json_t *points)
{
    size_t failed = 0, i;
    const char *key;
    json_t *point;
    json_array_foreach(points, i, point) failed += json_is_string(json_object_get(point, "failure"));
    json_object_foreach((json_t *)points, key, point) failed +=
        json_is_string(json_object_get(point, "failure"));
    return failed;
}

json_t *live_study_progress(const struct live_study *s)
{
    const json_t *points = is_complete(s) ? json_object_get(s->results, "points") : s->own.points;
    uint64_t all = number(s->note, "points"), done = number(s->note, "before") + s->own.since;
    if (is_complete(s) && !s->running)
        all = done = json_array_size(points);
    return json_pack("{s:i, s:I, s:I, s:I, s:b}", "version", (int)s->version, "all", (json_int_t)all, "done",
                     (json_int_t)(done < all ? done : all), "failed", (json_int_t)failures(points), "running",
                     s->running);
}

json_t *live_study_data(const struct live_study *s)
{
    bool complete = is_complete(s);
    json_t *header = complete ? s->results : json_object_get(s->note, "header");
    json_t *data = merged_points(header ? header : s->results,
                                 complete || !header ? json_object_get(s->results, "points") : s->own.points,
                                 s->more.points);
    json_set(data, "progress", live_study_progress(s));
    return data;
}

json_t *live_study_results_with_added(const char *dir)
{
    char *error = NULL;
    struct live_study *s = live_study_is(dir) ? live_study_open(dir, &error) : NULL;
    json_t *data = s && s->results && json_object_size(s->more.points) ? live_study_data(s) : NULL;
    if (data)
        json_object_del(data, "progress");
    if (s)
        live_study_close(s);
    free(error);
    return data;
}

/* --- adding --------------------------------------------------------------------------------------------- */

static bool is_point(const json_t *flat, const json_t *values, const char *set)
{
    const char *axis, *own = json_string_value(json_object_get(flat, "set"));
    json_t *value;
    json_object_foreach((json_t *)values, axis, value)
    {
        const json_t *other = json_object_get(flat, axis);
        bool equal = json_is_number(value) ? json_number_value(value) == json_number_value(other)
                                           : json_equal(value, other);
        if (!equal)
            return false;
    }
    return !json_is_string(json_object_get(flat, "failure")) && !strcmp(own ? own : "", set);
}

bool live_study_has(const struct live_study *s, const json_t *values, const json_t *set)
{
    json_t *data = live_study_data(s), *point;
    char *text = journal_points_settings(set);
    size_t i;
    bool has = false;
    json_array_foreach(json_object_get(data, "points"), i, point) has |= is_point(point, values, text);
    free(text);
    json_decref(data);
    return has;
}

static bool open_added(struct live_study *s)
{
    if (s->added < 0)
        s->added = study_folder_open(s->folder, ADDED, true);
    return s->added >= 0;
}

/* (What is wrong with a journal that is there and no file, live_study_add() says.) */
bool live_study_can_add(struct live_study *s, char **error)
{
    bool can = open_added(s) && (faccessat(s->added, JOURNAL, W_OK, AT_EACCESS) == 0 ||
                                 (errno == ENOENT && faccessat(s->added, ".", W_OK, AT_EACCESS) == 0));
    if (!can)
        *error =
            xasprintf("%s/%s/%s cannot be written, so no point can be added: %m", s->name, ADDED, JOURNAL);
    return can;
}

/* The error, which names the folder by dir, a path of this process alone: by the name that the user gave. */
static char *as_the_user_names_it(const struct live_study *s, const char *dir, char *error)
{
    size_t n = strlen(dir);
    if (strncmp(error, dir, n) != 0)
        return error;
    char *named = xasprintf("%s/%s%s", s->name, ADDED, error + n);
    free(error);
    return named;
}

bool live_study_add(struct live_study *s, struct digest key, json_t *record, FILE *notes, char **error)
{
    struct stat st;
    bool link =
        open_added(s) && fstatat(s->added, JOURNAL, &st, AT_SYMLINK_NOFOLLOW) == 0 && !S_ISREG(st.st_mode);
    if (s->added < 0 || link)
        return *error = xasprintf("%s/%s: %s", s->name, ADDED, link ? "journal is no file" : strerror(errno)),
               false;
    char *dir = xasprintf("/proc/self/fd/%d", s->added);
    struct journal *j = journal_open(dir, notes, error);
    bool failed = json_object_get(record, "failure");
    bool ok = j && journal_add(j, key, failed ? LINE_FAILED : LINE_DONE, record, true, error);
    journal_close(j);
    if (!ok)
        *error = as_the_user_names_it(s, dir, *error);
    free(dir);
    live_study_look(s);
    return ok;
}
