/* study_note.c - see study_note.h. */
#include "lab/study/study_note.h"
#include <limits.h>
#include <stdlib.h>
#include "files/json_set.h"
#include "files/json_write.h"
#include "kernel/xalloc.h"
#include "lab/study/study_parts.h"

static json_t *list_of(const char *const *words)
{
    json_t *list = json_array();
    for (; words && *words; words++)
        json_append(list, json_string(*words));
    return list;
}

/* The path from the root, of a file that exists. */
static json_t *path_of(const char *path)
{
    char real[PATH_MAX];
    return json_text(realpath(path, real) ? real : path);
}

static json_t *note_of(const struct study *s)
{
    json_t *note = json_object();
    json_set(note, "format", json_string("touchstone study 1"));
    json_set(note, "study", path_of(s->options.file));
    json_set(note, "program", path_of(s->program));
    json_set(note, "set", list_of(s->options.set));
    json_set(note, "arguments", list_of(s->options.arguments));
    json_set(note, "header", study_header(s));
    json_set(note, "points", json_integer((json_int_t)s->count));
    json_set(note, "before", json_integer((json_int_t)s->counts.before));
    json_set(note, "journal_from", json_integer((json_int_t)journal_size(s->journal)));
    return note;
}

bool study_note_write(const struct study *s, char **error)
{
    char *path = xasprintf("%s/%s", s->options.dir, STUDY_NOTE_NAME);
    bool ok = json_write(note_of(s), path, JSON_READABLE_DIGITS, error);
    free(path);
    return ok;
}
