/* export.c - see export.h: names of formats, and the files they are written to. */
#include "lab/export/export.h"
#include <stdlib.h>
#include <string.h>
#include "files/atomic_file.h"
#include "kernel/xalloc.h"
#include "lab/export/chrome_json.h"
#include "lab/export/csv_table.h"
#include "lab/export/export_progress.h"
#include "lab/export/otf2_folder.h"
#include "lab/export/paje.h"
#include "lab/export/picl.h"

/* Writes a whole file; false with *error (malloc'd). Whether `out` failed, it says itself. */
typedef bool export_writer(const struct timeline *l, FILE *out, const struct export_progress *p,
                           char **error);

static const struct {
    const char *name;
    const char *endings[3]; /* of files; the last is NULL */
    export_writer *write;   /* NULL: otf2 and csv, which are not one file */
} FORMATS[EXPORT_FORMATS] = {
    [EXPORT_JSON] = {"json", {".json"}, chrome_json_write},
    [EXPORT_PAJE] = {"paje", {".paje"}, paje_write},
    [EXPORT_OTF2] = {"otf2", {".otf2"}, NULL},
    [EXPORT_PICL] = {"picl", {".picl", ".trf"}, picl_write},
    [EXPORT_CSV] = {"csv", {".csv"}, NULL},
};

static const char *const TABLES[EXPORT_TABLES] = {
    [EXPORT_PIECES] = "pieces",     [EXPORT_CALLS] = "calls",     [EXPORT_WAITS] = "waits",
    [EXPORT_HANDLERS] = "handlers", [EXPORT_SYSTEMS] = "systems", [EXPORT_MESSAGES] = "messages",
    [EXPORT_BLOCKS] = "blocks"};

/* --- names --- */

const char *export_format_name(enum export_format f)
{
    return FORMATS[f].name;
}

enum export_format export_format_named(const char *name)
{
    enum export_format f = 0;
    while (f < EXPORT_FORMATS && strcmp(name, FORMATS[f].name) != 0)
        f++;
    return f;
}

enum export_table export_table_named(const char *name)
{
    enum export_table t = 0;
    while (t < EXPORT_TABLES && strcmp(name, TABLES[t]) != 0)
        t++;
    return t;
}

static bool ends_in(const char *path, const char *ending)
{
    size_t length = strlen(path), of_ending = strlen(ending);
    return length > of_ending && !strcmp(path + length - of_ending, ending);
}

enum export_format export_format_of_file(const char *path)
{
    for (enum export_format f = 0; f < EXPORT_FORMATS; f++)
        for (const char *const *ending = FORMATS[f].endings; *ending; ending++)
            if (ends_in(path, *ending))
                return f;
    return EXPORT_FORMATS;
}

/* OUT.csv and a table: OUT-TABLE.csv */
static char *table_file(const char *out, enum export_table table)
{
    size_t stem = strlen(out) - (ends_in(out, ".csv") ? strlen(".csv") : 0);
    return xasprintf("%.*s-%s.csv", (int)stem, out, TABLES[table]);
}

char **export_files(const struct export_request *r)
{
    char **files = xcalloc(3, sizeof *files);
    if (r->format == EXPORT_CSV && r->table == EXPORT_TABLES) {
        files[0] = table_file(r->out, EXPORT_PIECES);
        files[1] = table_file(r->out, EXPORT_MESSAGES);
    } else {
        files[0] = xstrdup(r->out);
    }
    return files;
}

/* --- files --- */

static bool write_file(const struct timeline *l, const struct export_request *r, const char *path,
                       enum export_table table, const struct export_progress *p, char **error)
{
    struct atomic_file f;
    if (!atomic_file_begin(&f, path, error))
        return false;
    bool made = true;
    if (r->format == EXPORT_CSV)
        csv_table_write(l->trace, table, f.out, p);
    else
        made = FORMATS[r->format].write(l, f.out, p, error);
    if (made)
        return atomic_file_end(&f, error);
    atomic_file_drop(&f);
    return false;
}

static bool write_all(const struct timeline *l, const struct export_request *r, struct export_progress *p,
                      char **error)
{
    if (r->format == EXPORT_OTF2)
        return otf2_folder_write(l, r->out, p, error);
    if (r->format != EXPORT_CSV || r->table != EXPORT_TABLES)
        return write_file(l, r, r->out, r->table, p, error);
    char **files = export_files(r);
    bool ok = write_file(l, r, files[0], EXPORT_PIECES, p, error) &&
              write_file(l, r, files[1], EXPORT_MESSAGES, p, error);
    free(files[0]);
    free(files[1]);
    free(files);
    return ok;
}

bool export_write(const struct trace *t, const struct export_request *r, char **error)
{
    struct timeline l = timeline_of(t);
    struct export_progress p = export_progress_begin(r->progress, t->node_count);
    bool ok = write_all(&l, r, &p, error);
    export_progress_end(&p);
    timeline_free(&l);
    return ok;
}
