/* flame.c - see flame.h. */
#include "lab/flame/flame.h"
#include <errno.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

enum { MOST_NODES = 1 << 20 };
static const char KINDS[] = "rfilcwo"; /* in the file, by enum flame_kind */

/* What is being read. */
struct reading {
    struct flame *flame;
    int profile;
    const char *path;
    const struct flame_selection *select;
    uint32_t nodes;
    struct flame_frame **spots; /* by number in the file */
    size_t spot_count;
};

static struct flame_frame *new_frame(struct flame_frame *parent, enum flame_kind kind, const char *name,
                                     const char *file, int line)
{
    struct flame_frame *f = xcalloc(1, sizeof *f);
    f->kind = kind, f->line = line, f->parent = parent;
    f->name = xstrdup(name);
    f->file = xstrdup(file);
    return f;
}

static int order(const struct flame_frame *f, const char *name, enum flame_kind kind, const char *file)
{
    int by_name = strcmp(f->name, name);
    int by_kind = by_name ? by_name : (int)f->kind - (int)kind;
    return by_kind ? by_kind : strcmp(f->file, file);
}

/* The child of that name. Functions of one name and file are one: a function may have moved within its
 * file. */
static struct flame_frame *child(struct flame_frame *parent, enum flame_kind kind, const char *name,
                                 const char *file, int line)
{
    struct flame_frame **at = &parent->children;
    while (*at && order(*at, name, kind, file) < 0)
        at = &(*at)->next;
    if (*at && order(*at, name, kind, file) == 0)
        return *at;
    struct flame_frame *f = new_frame(parent, kind, name, file, line);
    f->next = *at;
    return *at = f;
}

/* --- the file --- */

static bool damaged(const struct reading *r, size_t i, const char *what, char **error)
{
    *error = xasprintf(
        "%s: its %s %zu cannot be read: the file is damaged; write it again by touchstone run --profile",
        r->path, what, i);
    return false;
}

/* "PARENT KIND LINE NAME\tFILE" */
static bool read_spot(struct reading *r, size_t i, const char *text)
{
    unsigned long parent;
    char kind, *file = text ? strchr(text, '\t') : NULL;
    int line, at = 0;
    if (!file || sscanf(text, "%lu %c %d%n", &parent, &kind, &line, &at) != 3 || text[at++] != ' ' ||
        parent >= r->spot_count || !kind || !strchr(KINDS, kind))
        return false;
    if (i == 0) {
        r->spots[0] = r->flame->root;
        return true;
    }
    struct flame_frame *above = r->spots[parent];
    if (!above || parent == i)
        return false;
    char *name = xstrndup(text + at, (size_t)(file - text) - (size_t)at);
    r->spots[i] = child(above, (enum flame_kind)(strchr(KINDS, kind) - KINDS), name, file + 1, line);
    free(name);
    return true;
}

/* A parent comes before its children. */
static bool read_spots(struct reading *r, const json_t *list, char **error)
{
    r->spot_count = json_array_size(list);
    r->spots = xcalloc(r->spot_count + 1, sizeof(struct flame_frame *));
    for (size_t i = 0; i < r->spot_count; i++)
        if (!read_spot(r, i, json_string_value(json_array_get(list, i))))
            return damaged(r, i, "spot", error);
    return true;
}

static bool is_selected(const struct reading *r, unsigned long node)
{
    const struct flame_selection *s = r->select;
    return !s->nodes || (node < s->node_count && s->nodes[node]);
}

/* "0-3:123 7:99 ": the sum over the nodes selected. */
static bool sum_nodes(const struct reading *r, const char *text, vtime_sum *sum)
{
    *sum = 0;
    while (*text) {
        char *end;
        unsigned long first = strtoul(text, &end, 10),
                      last = *end == '-' ? strtoul(end + 1, &end, 10) : first;
        if (end == text || *end != ':' || first > last || last >= r->nodes)
            return false;
        vtime t = strtoull(text = end + 1, &end, 10);
        if (end == text || *end != ' ')
            return false;
        for (unsigned long k = first; k <= last; k++)
            *sum += is_selected(r, k) ? t : 0;
        text = end + 1;
    }
    return true;
}

static void add_line(struct reading *r, const struct flame_frame *f, const char *file, int line, vtime_sum t)
{
    struct flame *flame = r->flame;
    flame->lines = xgrown(flame->lines, flame->line_count, sizeof *flame->lines);
    const struct flame_frame *function = f->kind == FLAME_LIBRARY ? f->parent : f;
    struct flame_line *l = &flame->lines[flame->line_count++];
    *l = (struct flame_line){.file = xstrdup(file), .line = line, .function = xstrdup(function->name)};
    l->time[r->profile] = t;
}

/* "SPOT LINE FILE\tNODES:TIME ..." */
static bool read_share(struct reading *r, const char *text)
{
    unsigned long spot;
    int line, at = 0;
    vtime_sum t;
    const char *times = text ? strchr(text, '\t') : NULL;
    if (!times || sscanf(text, "%lu %d%n", &spot, &line, &at) != 2 || text[at] != ' ' ||
        spot >= r->spot_count || !sum_nodes(r, times + 1, &t))
        return false;
    struct flame_frame *f = r->spots[spot];
    f->self[r->profile] += t;
    if (line > 0 && t) {
        char *file = xstrndup(text + at + 1, (size_t)(times - text) - (size_t)at - 1);
        add_line(r, f, file, line, t);
        free(file);
    }
    return true;
}

static bool read_shares(struct reading *r, const json_t *list, char **error)
{
    for (size_t i = 0; i < json_array_size(list); i++)
        if (!read_share(r, json_string_value(json_array_get(list, i))))
            return damaged(r, i, "share", error);
    return true;
}

static bool read_nodes(struct reading *r, const json_t *j, char **error)
{
    struct flame *f = r->flame;
    json_int_t nodes = json_integer_value(json_object_get(j, "nodes"));
    if (nodes < 1 || nodes > MOST_NODES) {
        *error = xasprintf("%s: its number of nodes is none from 1 to %d", r->path, MOST_NODES);
        return false;
    }
    r->nodes = (uint32_t)nodes;
    for (uint32_t k = 0; k < r->nodes; k++)
        f->nodes[r->profile] += is_selected(r, k);
    if (f->nodes[r->profile])
        return true;
    *error = xasprintf("%s: has none of these nodes: its nodes are 0 to %u", r->path, r->nodes - 1);
    return false;
}

static bool read_profile(struct reading *r, const json_t *j, char **error)
{
    struct flame *f = r->flame;
    const json_t *tree = json_object_get(j, "tree");
    if (!json_object_get(j, "functions")) {
        *error = xasprintf("%s: is no profile: touchstone run --profile FILE writes one", r->path);
        return false;
    }
    if (!tree) {
        *error = xasprintf(
            "%s: has no paths of calls, as an older touchstone wrote it, or a study: build the program again "
            "with nxcc --profile, and write the profile by touchstone run --profile",
            r->path);
        return false;
    }
    const char *program = json_string_value(json_object_get(j, "program"));
    f->program[r->profile] = xstrdup(program ? program : "?");
    f->end[r->profile] = (vtime)json_integer_value(json_object_get(j, "end_ps"));
    return read_nodes(r, j, error) && read_spots(r, json_object_get(tree, "spots"), error) &&
           read_shares(r, json_object_get(tree, "shares"), error);
}

static bool load(struct flame *f, int profile, const char *path, const struct flame_selection *s,
                 char **error)
{
    json_error_t at;
    struct reading r = {.flame = f, .profile = profile, .path = path, .select = s};
    errno = 0;
    json_t *j = strcmp(path, "-") ? json_load_file(path, 0, &at) : json_loadf(stdin, 0, &at);
    if (!j) {
        *error = at.line < 0 && errno
                     ? xasprintf("%s cannot be read: %s", path, strerror(errno))
                     : xasprintf("%s: is no profile: touchstone run --profile FILE writes one", path);
        return false;
    }
    bool good = read_profile(&r, j, error);
    free(r.spots);
    json_decref(j);
    return good;
}

/* --- sums --- */

static void add_up(struct flame_frame *f)
{
    for (int p = 0; p < FLAME_PROFILES; p++)
        f->total[p] = f->self[p];
    for (struct flame_frame *c = f->children; c; c = c->next) {
        add_up(c);
        for (int p = 0; p < FLAME_PROFILES; p++)
            f->total[p] += c->total[p];
    }
}

static int by_place(const void *a, const void *b)
{
    const struct flame_line *x = a, *y = b;
    int files = strcmp(x->file, y->file);
    int places = files ? files : (x->line > y->line) - (x->line < y->line);
    return places ? places : strcmp(x->function, y->function);
}

static int most_first(const void *a, const void *b)
{
    const struct flame_line *x = a, *y = b;
    return x->time[0] != y->time[0] ? (x->time[0] < y->time[0]) - (x->time[0] > y->time[0]) : by_place(a, b);
}

static int most_changed_first(const void *a, const void *b)
{
    const struct flame_line *x = a, *y = b;
    vtime_sum left = x->time[0] - x->time[1], right = y->time[0] - y->time[1];
    left = left < 0 ? -left : left, right = right < 0 ? -right : right;
    return left != right ? (left < right) - (left > right) : by_place(a, b);
}

/* Lines of all paths, and of both profiles, become one. */
static void unite_lines(struct flame *f)
{
    size_t n = 0;
    if (!f->line_count)
        return;
    qsort(f->lines, f->line_count, sizeof *f->lines, by_place);
    for (size_t i = 1; i < f->line_count; i++) {
        if (by_place(&f->lines[n], &f->lines[i])) {
            f->lines[++n] = f->lines[i];
            continue;
        }
        for (int p = 0; p < FLAME_PROFILES; p++)
            f->lines[n].time[p] += f->lines[i].time[p];
        free(f->lines[i].file);
        free(f->lines[i].function);
    }
    f->line_count = n + 1;
    qsort(f->lines, f->line_count, sizeof *f->lines, flame_is_diff(f) ? most_changed_first : most_first);
}

struct flame *flame_load(const char *path, const char *before, const struct flame_selection *s, char **error)
{
    struct flame *f = xcalloc(1, sizeof *f);
    f->root = new_frame(NULL, FLAME_ROOT, "all", "", 0);
    if (load(f, FLAME_NOW, path, s, error) && (!before || load(f, FLAME_BEFORE, before, s, error))) {
        add_up(f->root);
        unite_lines(f);
        return f;
    }
    flame_free(f);
    return NULL;
}

static void free_frame(struct flame_frame *f)
{
    for (struct flame_frame *c = f->children, *next; c; c = next) {
        next = c->next;
        free_frame(c);
    }
    free(f->name);
    free(f->file);
    free(f);
}

void flame_free(struct flame *f)
{
    free_frame(f->root);
    for (size_t i = 0; i < f->line_count; i++) {
        free(f->lines[i].file);
        free(f->lines[i].function);
    }
    for (int p = 0; p < FLAME_PROFILES; p++)
        free(f->program[p]);
    free(f->lines);
    free(f);
}

bool flame_is_diff(const struct flame *f)
{
    return f->program[FLAME_BEFORE] != NULL;
}

double flame_share(const struct flame *f, const vtime_sum time[FLAME_PROFILES], int profile)
{
    vtime_sum all = f->root->total[profile];
    return all ? (double)time[profile] / (double)all : 0;
}

const char *flame_kind_name(enum flame_kind k)
{
    static const char *const NAMES[FLAME_KINDS] = {"all",  "function", "inlined", "library",
                                                   "call", "waiting",  "other"};
    return NAMES[k];
}
