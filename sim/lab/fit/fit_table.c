/* fit_table.c - reads a table of measurements as comma-separated values: a line of names, then lines of
 * cells; see fit_parts.h. A cell may be in double quotes, with quotes in it doubled. Empty lines and lines
 * that begin with # are skipped. */
#include "files/text_file.h"
#include "kernel/xalloc.h"
#include "lab/fit/fit_parts.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST = 64 << 20 };

/* Removes the blanks at both ends of a cell. */
static char *bare(char *cell)
{
    while (isspace((unsigned char)*cell))
        cell++;
    for (char *end = cell + strlen(cell); end > cell && isspace((unsigned char)end[-1]);)
        *--end = '\0';
    return cell;
}

/* Returns the cell at *rest, in position, and moves *rest behind it; to NULL after the last cell. */
static char *next_cell(char **rest)
{
    char *cell = *rest + strspn(*rest, " \t"), *to = cell, *from = cell;
    if (*cell != '"')
        return bare(strsep(rest, ","));
    for (from++; *from && (*from != '"' || from[1] == '"'); from++) {
        from += *from == '"';
        *to++ = *from;
    }
    from += *from == '"';
    *rest = strchr(from, ',');
    if (*rest)
        ++*rest;
    *to = '\0';
    return cell;
}

/* The names of the columns in order. NULL with *error. */
static json_t *read_names(char *line, const char *at, char **error)
{
    json_t *names = json_array();
    while (line)
        json_array_append_new(names, json_string(next_cell(&line)));
    for (size_t i = 0; i < json_array_size(names); i++)
        for (size_t k = 0; k <= i; k++) {
            const char *name = json_string_value(json_array_get(names, i));
            if (name && *name && (k == i || !json_equal(json_array_get(names, i), json_array_get(names, k))))
                continue;
            *error = xasprintf("%s: column %zu: a name is needed, and each only once", at, i + 1);
            json_decref(names);
            return NULL;
        }
    return names;
}

static bool read_row(char *line, const json_t *names, const char *at, fit_row *row, void *arg, char **error)
{
    json_t *cells = json_object();
    size_t i = 0;
    for (; line; i++) {
        const char *cell = next_cell(&line), *name = json_string_value(json_array_get(names, i));
        if (name && *cell && strcmp(cell, "-") != 0)
            json_object_set_new(cells, name, json_string(cell));
    }
    bool good = i == json_array_size(names);
    if (!good)
        *error = xasprintf("%s: %zu cells, and %zu names in the first line", at, i, json_array_size(names));
    good = good && row(arg, cells, at, error);
    json_decref(cells);
    return good;
}

bool fit_table(const char *path, fit_row *row, void *arg, char **error)
{
    const char *why;
    int wrong;
    char *all = text_file_read(path, LARGEST, &why, &wrong), *rest = all, *line;
    json_t *names = NULL;
    bool good = all;
    if (!all)
        *error = wrong ? xasprintf("%s:%d: %s", path, wrong, why) : xasprintf("%s: %s", path, why);
    for (size_t number = 1; good && (line = strsep(&rest, "\n")); number++) {
        char *text = bare(line), *at = xasprintf("%s:%zu", path, number);
        if (!*text || *text == '#')
            ;
        else if (!names)
            good = (names = read_names(text, at, error));
        else
            good = read_row(text, names, at, row, arg, error);
        free(at);
    }
    json_decref(names);
    free(all);
    return good;
}
