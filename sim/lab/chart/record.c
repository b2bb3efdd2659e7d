/* record.c - see record.h. */
#include "lab/chart/record.h"
#include "files/atomic_file.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "nx_api/contract/edit_distance.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* --- JSON ----------------------------------------------------------------------------------------------- */

struct json_writer {
    FILE *out;
    size_t count;
};

/* Writes the value as jansson lays it out, further lines indented. */
static void write_value(const json_t *value, const char *indent, FILE *out)
{
    char *text = xchecked(json_dumps(value, JSON_INDENT(1) | JSON_REAL_PRECISION(15) | JSON_ENCODE_ANY));
    for (const char *line = text; *line;) {
        size_t n = strcspn(line, "\n") + 1;
        n -= line[n - 1] == '\0';
        fwrite(line, 1, n, out);
        line += n;
        if (*line)
            fputs(indent, out);
    }
    free(text);
}

static bool write_point(void *arg, const json_t *point, char **error)
{
    struct json_writer *w = arg;
    (void)error;
    fputs(w->count++ ? ",\n  " : "\n  ", w->out);
    write_value(point, "  ", w->out);
    return !ferror(w->out) || (*error = xasprintf("cannot be written"), false);
}

static bool write_json(const struct record_points *points, FILE *out, char **error)
{
    struct json_writer w = {.out = out};
    const char *key;
    json_t *value;
    fputs("{\n \"format\": \"touchstone results 1\",\n", out);
    json_object_foreach(points->header, key, value)
    {
        fprintf(out, " \"%s\": ", key);
        write_value(value, " ", out);
        fputs(",\n", out);
    }
    fputs(" \"points\": [", out);
    bool ok = points->each(points->arg, write_point, &w, error);
    fputs("\n ]\n}\n", out);
    return ok;
}

/* --- comma-separated values ----------------------------------------------------------------------------- */

/* Writes the text in double quotes, with the quotes in it doubled. */
static void write_text(const char *text, FILE *out)
{
    fputc('"', out);
    for (; *text; text++) {
        if (*text == '"')
            fputc('"', out);
        fputc(*text, out);
    }
    fputc('"', out);
}

static void write_cell(const json_t *value, FILE *out)
{
    if (json_is_string(value))
        write_text(json_string_value(value), out);
    else if (json_is_integer(value))
        fprintf(out, "%lld", json_integer_value(value));
    else if (json_is_real(value))
        fprintf(out, "%.15g", json_real_value(value));
}

/* Adds the names of the point's figures to the columns, in order of appearance. Lists and objects are no
 * columns. */
static bool add_columns(void *arg, const json_t *point, char **error)
{
    const char *key;
    json_t *value;
    (void)error;
    json_object_foreach((json_t *)point, key, value)
    {
        if (!json_is_array(value) && !json_is_object(value) && !json_object_get(arg, key))
            json_set(arg, key, json_null());
    }
    return true;
}

struct csv_writer {
    FILE *out;
    json_t *columns;
};

static bool write_row(void *arg, const json_t *point, char **error)
{
    struct csv_writer *w = arg;
    const char *key, *comma = "";
    json_t *value;
    (void)error;
    json_object_foreach(w->columns, key, value)
    {
        fputs(comma, w->out);
        write_cell(json_object_get(point, key), w->out);
        comma = ",";
    }
    fputc('\n', w->out);
    return true;
}

static bool write_csv(const struct record_points *points, FILE *out, char **error)
{
    struct csv_writer w = {out, json_object()};
    const char *key, *comma = "";
    json_t *value;
    bool ok = points->each(points->arg, add_columns, w.columns, error);
    json_object_foreach(w.columns, key, value)
    {
        fprintf(out, "%s%s", comma, key);
        comma = ",";
    }
    fputc('\n', out);
    ok = ok && points->each(points->arg, write_row, &w, error);
    json_decref(w.columns);
    return ok;
}

/* --- files ---------------------------------------------------------------------------------------------- */

static bool write_file(const struct record_points *points, const char *dir, const char *name,
                       bool (*write)(const struct record_points *, FILE *, char **), char **error)
{
    struct atomic_file d;
    char *path = xasprintf("%s/%s", dir, name);
    bool begun = atomic_file_begin(&d, path, error);
    free(path);
    if (!begun)
        return false;
    if (write(points, d.out, error))
        return atomic_file_end(&d, error);
    atomic_file_drop(&d);
    return false;
}

bool record_write_json(const struct record_points *points, const char *dir, char **error)
{
    return write_file(points, dir, "results.json", write_json, error);
}

bool record_write_csv(const struct record_points *points, const char *dir, char **error)
{
    return write_file(points, dir, "results.csv", write_csv, error);
}

static bool each_of_list(void *list, bool (*visit)(void *, const json_t *, char **), void *to, char **error)
{
    size_t i;
    json_t *point;
    json_array_foreach((json_t *)list, i, point) if (!visit(to, point, error)) return false;
    return true;
}

bool record_read(const char *path, struct record_points *points, char **error)
{
    json_error_t why;
    json_t *root = json_load_file(path, 0, &why), *list = json_object_get(root, "points");
    bool ok = json_is_array(list) && json_is_object(json_object_get(root, "axes")) &&
              json_is_string(json_object_get(root, "title"));
    if (!root && why.line < 0)
        *error = xasprintf("%s cannot be read: %s", path, strerror(errno));
    else if (!root)
        *error = xasprintf("%s:%d: these are no results of touchstone study: %s", path, why.line, why.text);
    else if (!ok)
        *error = xasprintf("%s: these are no results of touchstone study", path);
    *points = (struct record_points){each_of_list, list, root};
    if (ok)
        return true;
    json_decref(root);
    return false;
}

void record_free(struct record_points *points)
{
    json_decref(points->header);
}

char *record_key_meant(const json_t *keys, const char *name)
{
    struct edit_nearest like = {.meant = name};
    const char *key;
    json_t *value;
    json_object_foreach((json_t *)keys, key, value) edit_see(&like, key);
    return like.best ? xasprintf("did you mean %s? There are", like.best) : xstrdup("there are");
}

char *record_no_axis(const json_t *axes, const char *name)
{
    char *names = json_keys_text(axes, NULL), *meant = record_key_meant(axes, name),
         *text = xasprintf("there is no axis %s; %s: %s", name, meant, names);
    free(names);
    free(meant);
    return text;
}

static bool add_figures(void *arg, const json_t *point, char **error)
{
    const char *key;
    json_t *value;
    (void)error;
    json_object_foreach((json_t *)point, key, value)
    {
        if (json_is_number(value))
            json_set(arg, key, json_incref(value));
    }
    return true;
}

char *record_no_figure(const struct record_points *points, const char *name)
{
    json_t *figures = json_object();
    char *error = NULL, *names = NULL;
    if (points->each(points->arg, add_figures, figures, &error))
        names = json_keys_text(figures, json_object_get(points->header, "axes"));
    char *meant = record_key_meant(figures, name),
         *text = xasprintf("no point has a figure %s; %s: %s", name, meant, names ? names : "");
    free(names);
    free(meant);
    free(error);
    json_decref(figures);
    return text;
}
