/* flame_text.c - profiles as folded stacks, tables and JSON: see flame.h. */
#include <inttypes.h>
#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "files/json_set.h"
#include "files/text_file.h"
#include "files/virtual_time.h"
#include "kernel/xalloc.h"
#include "lab/flame/flame.h"

enum { SHOWN_LINES = 40, SHOWN_CHANGES = 20, MOST_SOURCE = 16 << 20 };

/* --- folded stacks --- */

/* A ';' or an end of line would divide the stack. */
static void write_name(const char *name, FILE *out)
{
    for (; *name; name++)
        fputc(*name == ';' || *name == '\n' ? ':' : *name, out);
}

static void write_stack(const struct flame_frame *f, FILE *out)
{
    if (f->parent && f->parent->parent) {
        write_stack(f->parent, out);
        fputc(';', out);
    }
    write_name(f->name, out);
}

/* In digits; fprintf has none for 128 bits. */
static void write_sum(vtime_sum t, FILE *out)
{
    static const vtime_sum UPPER = INT64_C(1000000000000000000);
    if (t >= UPPER)
        fprintf(out, " %" PRId64 "%018" PRId64, (int64_t)(t / UPPER), (int64_t)(t % UPPER));
    else
        fprintf(out, " %" PRId64, (int64_t)t);
}

static void fold(const struct flame *flame, const struct flame_frame *f, FILE *out)
{
    if (f->self[FLAME_NOW] || f->self[FLAME_BEFORE]) {
        write_stack(f, out);
        if (flame_is_diff(flame))
            write_sum(f->self[FLAME_BEFORE], out);
        write_sum(f->self[FLAME_NOW], out);
        fputc('\n', out);
    }
    for (const struct flame_frame *c = f->children; c; c = c->next)
        fold(flame, c, out);
}

void flame_write_folded(const struct flame *f, FILE *out)
{
    fold(f, f->root, out);
}

/* --- tables --- */

/* The decimals of all seconds of a table: the run's whole time has five digits. */
static int decimals(const struct flame *f)
{
    double all = vt_sum_seconds(f->root->total[FLAME_NOW]);
    int after = all > 0 ? 4 - (int)floor(log10(all)) : 0;
    return after < 0 ? 0 : after < 12 ? after : 12;
}

static double percent(const struct flame *f, const vtime_sum t[FLAME_PROFILES], int profile)
{
    return 100 * flame_share(f, t, profile);
}

static void write_head(const struct flame *f, FILE *out)
{
    for (int p = 0; p < FLAME_PROFILES && f->program[p]; p++)
        fprintf(out, "%s%s: %" PRIu32 " node%s, %s; programs took %s of the nodes' time\n",
                !flame_is_diff(f) ? ""
                : p == FLAME_NOW  ? "now     "
                                  : "before  ",
                f->program[p], f->nodes[p], f->nodes[p] == 1 ? "" : "s",
                duration_text(vt_sum_seconds(f->end[p])).text,
                duration_text(vt_sum_seconds(f->root->total[p])).text);
    fputc('\n', out);
}

static int widest_first(const void *a, const void *b)
{
    const struct flame_frame *x = *(struct flame_frame *const *)a, *y = *(struct flame_frame *const *)b;
    if (x->total[0] != y->total[0])
        return x->total[0] < y->total[0] ? 1 : -1;
    return strcmp(x->name, y->name);
}

static bool is_worth_a_line(const struct flame *f, const struct flame_frame *frame)
{
    return flame_share(f, frame->total, FLAME_NOW) >= 0.001;
}

static void write_tree(const struct flame *flame, const struct flame_frame *f, int depth, FILE *out)
{
    size_t count = 0;
    if (f->parent) {
        fprintf(out, "%6.2f%% %6.2f%% %14.*f  %*s%s", percent(flame, f->total, 0), percent(flame, f->self, 0),
                decimals(flame), vt_sum_seconds(f->total[0]), 2 * (depth - 1), "", f->name);
        fprintf(out, f->kind == FLAME_INLINED ? "  (inlined)\n" : "\n");
    }
    for (const struct flame_frame *c = f->children; c; c = c->next)
        count++;
    const struct flame_frame **sorted = xcalloc(count + 1, sizeof *sorted), **at = sorted;
    for (const struct flame_frame *c = f->children; c; c = c->next)
        *at++ = c;
    qsort(sorted, count, sizeof *sorted, widest_first);
    for (size_t i = 0; i < count; i++)
        if (is_worth_a_line(flame, sorted[i]))
            write_tree(flame, sorted[i], depth + 1, out);
    free(sorted);
}

struct change {
    const struct flame_frame *frame;
    vtime_sum by;
};

static int largest_first(const void *a, const void *b)
{
    const struct change *x = a, *y = b;
    vtime_sum left = x->by < 0 ? -x->by : x->by, right = y->by < 0 ? -y->by : y->by;
    return (left < right) - (left > right);
}

static void collect_changes(const struct flame_frame *f, struct change **list, size_t *count)
{
    if (f->self[0] != f->self[1]) {
        *list = xreallocarray(*list, *count + 1, sizeof **list);
        (*list)[(*count)++] = (struct change){f, f->self[0] - f->self[1]};
    }
    for (const struct flame_frame *c = f->children; c; c = c->next)
        collect_changes(c, list, count);
}

static void write_changes(const struct flame *f, FILE *out)
{
    struct change *list = NULL;
    size_t count = 0;
    int after = decimals(f);
    collect_changes(f->root, &list, &count);
    if (count)
        qsort(list, count, sizeof *list, largest_first);
    else
        fputs("Nothing has changed.\n", out);
    if (count)
        fprintf(out, "%14s %14s %14s  %s\n", "before", "now", "change (s)", "frame");
    for (size_t i = 0; i < count && i < SHOWN_CHANGES; i++) {
        fprintf(out, "%14.*f %14.*f %+14.*f  ", after, vt_sum_seconds(list[i].frame->self[1]), after,
                vt_sum_seconds(list[i].frame->self[0]), after, vt_sum_seconds(list[i].by));
        write_stack(list[i].frame, out);
        fputc('\n', out);
    }
    if (count > SHOWN_CHANGES)
        fprintf(out, "and %zu smaller changes (-f folded has them all)\n", count - SHOWN_CHANGES);
    free(list);
}

void flame_write_text(const struct flame *f, FILE *out)
{
    write_head(f, out);
    if (flame_is_diff(f)) {
        write_changes(f, out);
        return;
    }
    fprintf(out, "%7s %7s %14s  %s\n", "total", "self", "seconds", "frame");
    write_tree(f, f->root, 0, out);
    fputs("\nFrames below 0.1 % are left out (-f folded has them all).\n", out);
}

/* --- JSON --- */

static json_t *frame_json(const struct flame *flame, const struct flame_frame *f)
{
    json_t *j = json_pack("{s:s, s:s, s:o, s:o}", "name", f->name, "kind", flame_kind_name(f->kind), "value",
                          json_ps(f->total[0]), "self_ps", json_ps(f->self[0]));
    if (flame_is_diff(flame)) {
        json_set(j, "before", json_ps(f->total[1]));
        json_set(j, "self_before_ps", json_ps(f->self[1]));
    }
    if (*f->file) {
        json_set(j, "file", json_string(f->file));
        json_set(j, "line", json_integer(f->line));
    }
    json_t *children = json_array();
    for (const struct flame_frame *c = f->children; c; c = c->next)
        json_append(children, frame_json(flame, c));
    json_set(j, "children", children);
    return j;
}

static void dump(json_t *j, FILE *out)
{
    json_dumpf(j, out, JSON_INDENT(1));
    fputc('\n', out);
    json_decref(j);
}

void flame_write_json(const struct flame *f, FILE *out)
{
    dump(frame_json(f, f->root), out);
}

void flame_write_lines_json(const struct flame *f, FILE *out)
{
    json_t *list = json_array();
    for (size_t i = 0; i < f->line_count; i++) {
        const struct flame_line *l = &f->lines[i];
        json_t *j = json_pack("{s:s, s:i, s:s, s:o}", "file", l->file, "line", l->line, "function",
                              l->function, "time_ps", json_ps(l->time[0]));
        if (flame_is_diff(f))
            json_set(j, "before_ps", json_ps(l->time[1]));
        json_append(list, j);
    }
    dump(list, out);
}

/* --- lines of source --- */

/* The source that was asked for last, if it can be read. */
struct source {
    const char *path;
    char *text;
};

/* Writes a line of the file, without what stands before it in the line. */
static void write_source(struct source *s, const struct flame_line *l, FILE *out)
{
    const char *why;
    int at;
    if (!s->path || strcmp(s->path, l->file)) {
        free(s->text);
        s->path = l->file;
        s->text = text_file_read(l->file, MOST_SOURCE, &why, &at);
    }
    const char *text = s->text;
    for (int i = 1; text && i < l->line; i++)
        text = (text = strchr(text, '\n')) ? text + 1 : NULL;
    if (!text)
        return;
    text += strspn(text, " \t");
    fprintf(out, "  %.*s", (int)strcspn(text, "\r\n"), text);
}

static void write_line(const struct flame *f, const struct flame_line *l, struct source *s, FILE *out)
{
    char *place = xasprintf("%s:%d", l->file, l->line);
    fprintf(out, "%6.2f%% ", percent(f, l->time, 0));
    int after = decimals(f);
    if (flame_is_diff(f))
        fprintf(out, "%14.*f %14.*f %+14.*f", after, vt_sum_seconds(l->time[1]), after,
                vt_sum_seconds(l->time[0]), after, vt_sum_seconds(l->time[0] - l->time[1]));
    else
        fprintf(out, "%14.*f", after, vt_sum_seconds(l->time[0]));
    fprintf(out, "  %-28s %-18s", place, l->function);
    write_source(s, l, out);
    fputc('\n', out);
    free(place);
}

/* Lines of 0.00 % say nothing, but for a change. */
static bool is_shown(const struct flame *f, const struct flame_line *l)
{
    return flame_is_diff(f) || percent(f, l->time, 0) >= 0.005;
}

void flame_write_lines(const struct flame *f, FILE *out)
{
    struct source s = {0};
    vtime_sum shown = 0, all = 0;
    size_t count = 0;
    write_head(f, out);
    if (flame_is_diff(f))
        fprintf(out, "%7s %14s %14s %14s  %-28s %s\n", "share", "before", "now", "change (s)", "line",
                "function");
    else
        fprintf(out, "%7s %14s  %-28s %s\n", "share", "seconds", "line", "function");
    for (size_t i = 0; i < f->line_count; i++) {
        all += f->lines[i].time[0];
        if (count == SHOWN_LINES || !is_shown(f, &f->lines[i]))
            continue;
        count++;
        shown += f->lines[i].time[0];
        write_line(f, &f->lines[i], &s, out);
    }
    if (f->line_count > count)
        fprintf(out, "%s in %zu more line%s (-f json has them all)\n",
                duration_text(vt_sum_seconds(all - shown)).text, f->line_count - count,
                f->line_count - count == 1 ? "" : "s");
    fprintf(out, "\nThe lines compute for %s; the rest is the system's time and waiting.\n",
            duration_text(vt_sum_seconds(all)).text);
    free(s.text);
}
