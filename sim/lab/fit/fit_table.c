/* fit_table.c - a table of measurements as comma-separated values: a line of names, then lines of cells. Cells may be in
 * double quotes, with quotes in them doubled. Empty lines and lines that begin with # are passed over. */
#include "kernel/xalloc.h"
#include "lab/fit/fit_parts.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

bool fit_number(const char *text, double *value, double *half)
{
    char *end;
    *value = strtod(text, &end);
    if (end == text || *end || !isfinite(*value) || strchr(text, 'x') || strchr(text, 'X'))
        return false;
    const char *power = strpbrk(text, "eE"), *point = strchr(text, '.');
    long digits = point ? (power ? power : end) - point - 1 : 0;
    *half = 0.5 * pow(10, (power ? strtod(power + 1, NULL) : 0) - (double)digits);
    return true;
}

/* Takes the blanks at both ends off. */
static char *bare(char *cell)
{
    while (isspace((unsigned char)*cell))
        cell++;
    for (char *end = cell + strlen(cell); end > cell && isspace((unsigned char)end[-1]);)
        *--end = '\0';
    return cell;
}

/* The cell at *rest, which then is behind it, or NULL after the last. The text is changed. */
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

/* The names of the columns, in their order; NULL with *error. */
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
    FILE *in = fopen(path, "re");
    char *line = NULL;
    size_t size = 0, number = 0;
    json_t *names = NULL;
    bool good = in;
    if (!in)
        *error = xasprintf("%s: %m", path);
    while (good && getline(&line, &size, in) >= 0) {
        char *text = bare(line), *at = xasprintf("%s:%zu", path, ++number);
        if (!*text || *text == '#')
            ;
        else if (!names)
            good = (names = read_names(text, at, error));
        else
            good = read_row(text, names, at, row, arg, error);
        free(at);
    }
    if (in)
        fclose(in);
    json_decref(names);
    free(line);
    return good;
}
