/* point_request.c - see point_request.h. */
#include "lab/serve/point_request.h"
#include <libgen.h>
#include <stdlib.h>
#include <string.h>
#include "files/json_set.h"
#include "files/number.h"
#include "kernel/xalloc.h"
#include "lab/serve/added_runs.h"
#include "lab/study/spec_read.h"

static const char NO_NOTE[] =
    "this folder does not tell which study it belongs to: run touchstone study once more, which writes "
    "study.json";

/* --- settings ------------------------------------------------------------------------------------------- */

/* Is text KEY=NUMBER? Values that are texts could name files: those are the study file's to give. */
static bool is_setting(const char *text)
{
    double value, unit;
    size_t key = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.");
    return key && text[key] == '=' && strlen(text) <= ADDED_MOST_SETTING &&
           number_read(text + key + 1, &value, &unit);
}

/* Takes the request's settings into r. */
static bool read_set(struct point_request *r, const json_t *set, char **error)
{
    size_t i;
    json_t *one;
    r->set = json_array();
    if ((set && !json_is_array(set)) || json_array_size(set) > ADDED_MOST_SETTINGS)
        return *error =
                   xasprintf("set: a list of at most %d texts KEY=NUMBER is needed", ADDED_MOST_SETTINGS),
               false;
    json_array_foreach(set, i, one)
    {
        const char *text = json_string_value(one);
        if (!text || !is_setting(text))
            return *error = xasprintf("set: '%.64s' is not KEY=NUMBER, such as system.interrupt_us=150",
                                      text ? text : ""),
                   false;
        json_append(r->set, json_string(text));
    }
    return true;
}

/* --- the point ------------------------------------------------------------------------------------------ */

/* The list's texts, ended by NULL; they stay the list's. */
static const char **texts(const json_t *list, const json_t *more)
{
    size_t count = json_array_size(list), all = count + json_array_size(more), to = 0;
    const char **words = xcalloc(all + 1, sizeof *words);
    for (size_t i = 0; i < all; i++) {
        const char *text =
            json_string_value(i < count ? json_array_get(list, i) : json_array_get(more, i - count));
        if (text)
            words[to++] = text;
    }
    return words;
}

static char *text_of(const json_t *note, const char *key)
{
    const char *text = json_string_value(json_object_get(note, key));
    return xstrdup(text ? text : "");
}

/* The name, with the settings. */
static char *name_of(const struct spec *s, const struct point *p, const json_t *set)
{
    char *name = point_name(s, p);
    size_t i;
    json_t *one;
    json_array_foreach(set, i, one) words_append(&name, ", %s", json_string_value(one));
    return name;
}

static bool make(struct point_request *r, const struct spec *s, struct inputs *in, const json_t *values,
                 const struct point_run_files *files, char **error)
{
    struct point p;
    if (point_choose(s, values, &p, error) != POINT_WANTED || !inputs_of(in, &p, &r->key, NULL, error))
        return false;
    r->values = point_values(s, &p);
    r->name = name_of(s, &p, r->set);
    r->argv = point_run_argv(s, in, &p, files);
    r->limit_s = s->max_wall_s > 0 ? s->max_wall_s + 2 : 0;
    return true;
}

/* Reads the study file and makes the point. */
static bool read_point(struct point_request *r, const json_t *note, const json_t *values,
                       const struct point_request_places *places, char **error)
{
    char *file = text_of(note, "study"), *program = text_of(note, "program");
    const char **set = texts(json_object_get(note, "set"), r->set);
    const char **arguments = texts(json_object_get(note, "arguments"), NULL);
    struct inputs_paths paths = {places->runner, program, places->machines, r->dir, set, arguments};
    struct point_run_files files = {places->runner, program, r->json, NULL};
    struct spec *s = spec_read(file, error);
    struct inputs *in = s ? inputs_open(s, &paths, error) : NULL;
    bool ok = in && make(r, s, in, values, &files, error);
    inputs_close(in);
    spec_free(s);
    free(set);
    free(arguments);
    free(file);
    free(program);
    return ok;
}

bool point_request_read(struct point_request *r, const json_t *note, const json_t *request,
                        const struct point_request_places *places, char **error)
{
    const json_t *values = json_object_get(request, "values");
    if (!note)
        return *error = xstrdup(NO_NOTE), false;
    if (!json_is_object(values))
        return *error = xstrdup("values: an object with a value for each axis is needed"), false;
    char *file = text_of(note, "study");
    *r = (struct point_request){.dir = xstrdup(dirname(file)),
                                .json = xasprintf("%s/%u.json", places->scratch, places->number)};
    free(file);
    if (read_set(r, json_object_get(request, "set"), error) && read_point(r, note, values, places, error))
        return true;
    point_request_clear(r);
    return false;
}

void point_request_clear(struct point_request *r)
{
    json_decref(r->values);
    json_decref(r->set);
    words_free(r->argv);
    free(r->name);
    free(r->json);
    free(r->dir);
    *r = (struct point_request){0};
}

/* --- the form ------------------------------------------------------------------------------------------- */

static json_t *axis_form(const struct spec_axis *axis)
{
    bool open = point_axis_is_open(axis);
    json_t *form = json_pack("{s:s, s:b}", "name", axis->name, "open", open), *values = json_array();
    char label[SPEC_MAX_LABEL];
    for (size_t i = 0; !open && i < axis->count; i++) {
        const char *text;
        spec_value(axis, i, &text, label);
        json_append(values, json_string(text));
    }
    json_set(form, "values", values);
    return form;
}

json_t *point_request_form(const json_t *note)
{
    char *error = NULL, *file = text_of(note, "study");
    struct spec *s = note ? spec_read(file, &error) : NULL;
    json_t *form = s ? json_array() : json_object();
    for (size_t i = 0; s && i < s->axis_count; i++)
        if (s->axes[i].kind != SPEC_DERIVED)
            json_append(form, axis_form(&s->axes[i]));
    if (!s)
        json_set(form, "error", json_text(error ? error : NO_NOTE));
    spec_free(s);
    free(error);
    free(file);
    return form;
}
