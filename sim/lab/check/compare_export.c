/* compare_export.c - see compare_export.h. */
#include "lab/check/compare_export.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/check/compare_print.h"

#include <stdlib.h>
#include <string.h>

/* --- JSON ----------------------------------------------------------------------------------------------- */

static const char *word(enum compare_verdict v)
{
    static const char *const WORDS[] = {"same", "differs", "better", "new", "worse", "missing", "failed"};
    return WORDS[v];
}

static json_t *value_or_null(const json_t *value)
{
    return value ? json_deep_copy(value) : json_null();
}

static json_t *figure_json(const struct compare_figure *f)
{
    return xchecked(json_pack("{s:s, s:s, s:o, s:o, s:o, s:o}", "name", f->name, "verdict", word(f->verdict),
                              "before", value_or_null(f->before), "after", value_or_null(f->after), "change",
                              json_real_or_null(f->change), "change_pct", json_real_or_null(f->change_pct)));
}

static json_t *point_json(const struct compare_point *p)
{
    json_t *o = xchecked(
        json_pack("{s:s, s:s, s:s}", "study", p->study, "point", p->name, "verdict", word(p->verdict)));
    json_t *figures = xchecked(json_array());
    for (size_t i = 0; i < p->figure_count; i++)
        json_append(figures, figure_json(&p->figures[i]));
    json_set(o, "figures", figures);
    json_set(o, "failure", json_string_or_null(p->failure));
    return o;
}

void compare_write_json(struct compare_point *const points[], size_t count, FILE *out)
{
    json_t *list = xchecked(json_array());
    for (size_t i = 0; i < count; i++)
        json_append(list, point_json(points[i]));
    json_t *all = xchecked(json_pack("{s:s, s:o}", "format", "touchstone check 1", "points", list));
    json_dumpf(all, out, JSON_INDENT(1) | JSON_REAL_PRECISION(15));
    fputc('\n', out);
    json_decref(all);
}

/* --- GitHub's annotations ------------------------------------------------------------------------------- */

/* Writes a text of a workflow command. A title ends at a ',' and a ':', which are escaped, too. */
static void write_escaped(const char *text, const char *special, FILE *out)
{
    for (; *text; text++)
        if (strchr(special, *text))
            fprintf(out, "%%%02X", (unsigned char)*text);
        else
            fputc(*text, out);
}

static void write_annotation(const struct compare_point *p, FILE *out)
{
    char *line = NULL;
    size_t size;
    FILE *f = xchecked(open_memstream(&line, &size));
    compare_print_short(p, f);
    fclose(f);
    line[strcspn(line, "\n")] = '\0';
    fputs("::error title=", out);
    write_escaped(p->study, "%\r\n:,", out);
    write_escaped(": ", "%\r\n:,", out);
    write_escaped(p->name, "%\r\n:,", out);
    fputs("::", out);
    write_escaped(line, "%\r\n", out);
    fputc('\n', out);
    free(line);
}

void compare_write_github(struct compare_point *const points[], size_t count, FILE *out)
{
    for (size_t i = 0; i < count; i++)
        if (compare_is_failure(points[i]->verdict))
            write_annotation(points[i], out);
}
