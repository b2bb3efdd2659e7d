/* page_item.c - see page_item.h. */
#include "lab/page/page_item.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "files/json_set.h"
#include "files/text_file.h"
#include "kernel/xalloc.h"
#include "lab/page/page_deadlock.h"
#include "lab/render/ply_file.h"
#include "trace/trace_format.h"

enum { HEAD = 4096, MOST_TEXT = 1 << 30 };

static const char ACCEPTED[] =
    "a page shows results of touchstone run --json and --profile, of study and of tables, traces of "
    "run --trace, deadlocks of run --deadlock, paths of trace why --json, folded stacks, and PLY surfaces";

/* --- JSON ----------------------------------------------------------------------------------------------- */

static bool has(const json_t *j, const char *key, json_type type)
{
    const json_t *value = json_object_get(j, key);
    return value && json_typeof(value) == type;
}

/* Which of touchstone's results it is; PAGE_KINDS: none. */
static enum page_kind kind_of_json(const json_t *j)
{
    if (has(j, "points", JSON_ARRAY) && has(j, "axes", JSON_OBJECT))
        return PAGE_STUDY;
    if (has(j, "rows", JSON_ARRAY) && has(j, "summary", JSON_OBJECT))
        return PAGE_TABLES;
    if (has(j, "functions", JSON_ARRAY) && has(j, "classes", JSON_OBJECT))
        return PAGE_PROFILE;
    if (has(j, "nodes", JSON_ARRAY) && has(j, "cycle", JSON_ARRAY))
        return PAGE_DEADLOCK;
    if (has(j, "node", JSON_ARRAY) && has(j, "outcome", JSON_STRING))
        return PAGE_RUN;
    return has(j, "critical_path", JSON_OBJECT) && has(j, "sentences", JSON_ARRAY) ? PAGE_PATH : PAGE_KINDS;
}

json_t *page_json_within_53_bits(json_t *j)
{
    const int64_t most = INT64_C(1) << 53;
    json_int_t value = json_integer_value(j);
    const char *key;
    json_t *member, *text;
    size_t i;
    void *next;
    json_object_foreach_safe(j, next, key, member)
        json_set(j, key, page_json_within_53_bits(json_incref(member)));
    json_array_foreach(j, i, member) json_array_set_new(j, i, page_json_within_53_bits(json_incref(member)));
    if (value >= -most && value <= most)
        return j;
    text = json_sprintf("%lld", value);
    json_decref(j);
    return xchecked(text);
}

static bool read_json(struct page_item *item, const char *path, char **error)
{
    json_error_t why;
    item->json = json_load_file(path, 0, &why);
    if (!item->json)
        return *error = xasprintf("%s:%d: %s", path, why.line, why.text), false;
    item->kind = kind_of_json(item->json);
    json_t *deadlock = item->kind == PAGE_KINDS ? NULL : page_deadlock_make(item->json);
    if (item->kind == PAGE_KINDS || (item->kind == PAGE_DEADLOCK && !deadlock))
        return *error = xasprintf("%s: JSON, but not of touchstone: %s", path, ACCEPTED), false;
    if (item->kind == PAGE_DEADLOCK) {
        json_decref(item->json);
        item->json = deadlock;
        return true;
    }
    item->deadlock = deadlock;
    json_object_del(item->json, "deadlock");
    item->json = page_json_within_53_bits(item->json);
    return true;
}

/* --- folded stacks -------------------------------------------------------------------------------------- */

/* Does the line end with a space and a whole number? */
static bool is_stack(const char *line, size_t length)
{
    size_t digits = 0;
    while (digits < length && line[length - 1 - digits] >= '0' && line[length - 1 - digits] <= '9')
        digits++;
    return digits && digits + 1 < length && line[length - 1 - digits] == ' ';
}

static bool read_stacks(struct page_item *item, const char *path, char **error)
{
    const char *why;
    int line = 0, number = 1;
    item->text = text_file_read(path, MOST_TEXT, &why, &line);
    if (!item->text)
        return *error = line ? xasprintf("%s:%d: %s: %s", path, line, why, ACCEPTED)
                             : xasprintf("%s: %s", path, why),
               false;
    item->kind = PAGE_STACKS;
    for (const char *at = item->text; *at; number++) {
        size_t length = strcspn(at, "\n");
        if (length && *at != '#' && !is_stack(at, length))
            return *error = xasprintf("%s:%d: no folded stack, which ends with a number: %s", path, number,
                                      ACCEPTED),
                   false;
        at += length + (at[length] == '\n');
    }
    return true;
}

/* --- files ---------------------------------------------------------------------------------------------- */

static bool read_trace(struct page_item *item, const char *path, const struct trace_selection *selection,
                       char **error)
{
    item->kind = PAGE_TRACE;
    item->trace = item->own_trace = trace_load(path, selection, error);
    return item->trace;
}

static bool read_surface(struct page_item *item, const char *path, char **error)
{
    item->kind = PAGE_SURFACE;
    return ply_file_read(path, &item->mesh, error);
}

/* Reads a file by what it begins with. */
static bool read_file(struct page_item *item, const char *path, const struct trace_selection *selection,
                      char **error)
{
    char head[HEAD];
    FILE *in = fopen(path, "re");
    if (!in)
        return *error = xasprintf("%s: cannot be read: %s", path, strerror(errno)), false;
    size_t size = fread(head, 1, sizeof head, in), space = 0;
    fclose(in);
    if (size == 0)
        return *error = xasprintf("%s: is empty: %s", path, ACCEPTED), false;
    if (size >= 4 && !memcmp(head, "ply", 3) && strchr("\r\n", head[3]))
        return read_surface(item, path, error);
    if (size >= sizeof TRACE_MAGIC - 1 && !memcmp(head, TRACE_MAGIC, sizeof TRACE_MAGIC - 1))
        return read_trace(item, path, selection, error);
    while (space < size && strchr(" \t\r\n", head[space]))
        space++;
    return space < size && head[space] == '{' ? read_json(item, path, error) : read_stacks(item, path, error);
}

/* The file of results in a folder: a study's, or the tables'. NULL with *error. */
static char *results_in(const char *folder, char **error)
{
    static const char *const NAMES[] = {"results.json", "tables.json"};
    struct stat st;
    for (size_t i = 0; i < sizeof NAMES / sizeof *NAMES; i++) {
        char *path = xasprintf("%s/%s", folder, NAMES[i]);
        if (stat(path, &st) == 0)
            return path;
        free(path);
    }
    *error = xasprintf(
        "%s: a folder without results.json of touchstone study and tables.json of touchstone tables", folder);
    return NULL;
}

bool page_item_read(struct page_item *item, const char *path, const struct trace_selection *selection,
                    char **error)
{
    struct stat st;
    char *file = stat(path, &st) == 0 && S_ISDIR(st.st_mode) ? results_in(path, error) : xstrdup(path);
    *item = (struct page_item){.name = xstrdup(path)};
    bool ok = file && read_file(item, file, selection, error);
    free(file);
    if (!ok)
        page_item_free(item);
    return ok;
}

/* --- what it is about ----------------------------------------------------------------------------------- */

static char *run_text(const char *program, json_int_t nodes, const char *machine)
{
    if (!program || !machine)
        return NULL;
    return xasprintf("%s on %" JSON_INTEGER_FORMAT " node%s of %s", basename(program), nodes,
                     nodes == 1 ? "" : "s", machine);
}

char *page_item_about(const struct page_item *item)
{
    const struct trace *t = item->trace;
    const json_t *j = item->json;
    if (t)
        return run_text(t->program, trace_nodes_ran(t), t->machine);
    if (item->kind == PAGE_RUN || item->kind == PAGE_PROFILE || item->kind == PAGE_PATH)
        return run_text(json_string_value(json_object_get(j, "program")),
                        json_integer_value(json_object_get(j, "nodes")),
                        json_string_value(json_object_get(j, "machine")));
    if (item->kind == PAGE_TABLES)
        return xstrdup("Tables of Bajaj & Lin");
    const char *title = item->kind == PAGE_STUDY ? json_string_value(json_object_get(j, "title")) : NULL;
    return title && *title ? xstrdup(title) : NULL;
}

char *page_item_title(const struct page_item *item)
{
    const char *program = json_string_value(json_object_get(item->json, "program"));
    return item->kind == PAGE_DEADLOCK && program ? xasprintf("Deadlock of %s", basename(program))
                                                  : xstrdup(item->name);
}

void page_item_free(struct page_item *item)
{
    free(item->name);
    free(item->text);
    json_decref(item->json);
    json_decref(item->deadlock);
    if (item->own_trace)
        trace_free(item->own_trace);
    mesh_free(&item->mesh);
}
