/* plan_read.c - see plan_read.h. */
#include "timing/plan_read.h"
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "files/text_file.h"
#include "kernel/xalloc.h"

enum { MOST_BYTES = 1 << 30, MOST_NODES = 1 << 20, MOST_PPM = 10000000, MOST_WORDS = 5 };

/* A line under way. */
struct reader {
    struct plan *plan;
    unsigned line;
    char *word[MOST_WORDS]; /* those before the first KEY=VALUE */
    int words;
    bool begun; /* the first line, with the format's name, has been read */
    char *error;
};

#define TWICE "another line says this of the same"

static bool fail(struct reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));
static bool fail(struct reader *r, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    char *what = xvasprintf(format, list);
    va_end(list);
    r->error = xasprintf("%s:%u: %s", r->plan->path, r->line, what);
    free(what);
    return false;
}

/* --- words --- */

static bool number_at(struct reader *r, int i, const char *what, uint64_t most, uint64_t *value)
{
    const char *text = r->word[i];
    char *end;
    errno = 0;
    *value = strtoull(text, &end, 10);
    if (*text < '0' || *text > '9' || *end || errno)
        return fail(r, "%s: %s is a whole number, not '%s'", r->word[0], what, text);
    if (*value > most)
        return fail(r, "%s: %s is at most %" PRIu64 ", not %s", r->word[0], what, most, text);
    return true;
}

/* A node's number, or "host". */
static bool node_at_word(struct reader *r, int i, uint32_t *node)
{
    const struct plan *p = r->plan;
    uint64_t value;
    if (!p->node)
        return fail(r, "%s: a line 'nodes COUNT' must come before", r->word[0]);
    *node = p->nodes;
    if (!strcmp(r->word[i], "host"))
        return true;
    if (!number_at(r, i, "a node", UINT32_MAX, &value))
        return false;
    if (value >= p->nodes)
        return fail(r, "%s: there is no node %" PRIu64 ": nodes are 0 to %u, or host", r->word[0], value,
                    p->nodes - 1);
    *node = (uint32_t)value;
    return true;
}

/* --- lines --- */

static void append(struct plan_list *l, struct plan_item item)
{
    if ((l->count & (l->count - 1)) == 0)
        l->item = xreallocarray(l->item, l->count ? 2 * l->count : 1, sizeof *l->item);
    l->item[l->count++] = item;
}

static bool read_format(struct reader *r)
{
    if (r->begun || r->words != 2 || strcmp(r->word[0], "touchstone-schedule"))
        return fail(r, "%s",
                    r->begun ? "the format's name stands twice"
                             : "this is no schedule: one begins with the line 'touchstone-schedule 1'");
    if (strcmp(r->word[1], "1"))
        return fail(r, "this touchstone reads schedules of format 1, not %s", r->word[1]);
    return r->begun = true;
}

static bool read_nodes(struct reader *r)
{
    struct plan *p = r->plan;
    uint64_t n;
    if (p->node)
        return fail(r, "nodes: stands twice");
    if (!number_at(r, 1, "the number of nodes", MOST_NODES, &n))
        return false;
    if (n == 0)
        return fail(r, "nodes: a run has at least 1");
    p->nodes = (uint32_t)n;
    p->node = xcalloc(n + 1, sizeof *p->node);
    return true;
}

static bool read_program(struct reader *r)
{
    uint64_t number;
    if (r->plan->has_program)
        return fail(r, "program: stands twice");
    if (!number_at(r, 1, "the number of a program", UINT32_MAX, &number))
        return false;
    r->plan->program = (uint32_t)number;
    return r->plan->has_program = true;
}

/* What the lines match and handler are for. */
static bool read_use(struct reader *r)
{
    struct plan *p = r->plan;
    if (p->orders || p->delays)
        return fail(r, "%s: one line, 'orders' or 'delays', is enough", r->word[0]);
    *(strcmp(r->word[0], "orders") ? &p->delays : &p->orders) = true;
    return true;
}

static bool read_speed(struct reader *r)
{
    uint32_t node = 0;
    uint64_t ppm;
    if (!node_at_word(r, 1, &node) || !number_at(r, 2, "parts per million", MOST_PPM, &ppm))
        return false;
    if (r->plan->node[node].speed_ppm)
        return fail(r, TWICE);
    r->plan->node[node].speed_ppm = (uint32_t)ppm;
    return true;
}

enum { MOST_PS_BITS = 60 };
#define MOST_PS (UINT64_C(1) << MOST_PS_BITS)
static const char PICOSECONDS[] = "a delay in picoseconds";

static bool read_start(struct reader *r)
{
    uint32_t node = 0;
    uint64_t by;
    if (!node_at_word(r, 1, &node) || !number_at(r, 2, PICOSECONDS, MOST_PS, &by))
        return false;
    if (r->plan->node[node].start)
        return fail(r, TWICE);
    r->plan->node[node].start = by;
    return true;
}

static bool read_delay(struct reader *r, uint32_t *node, struct plan_item *item)
{
    item->line = r->line;
    return node_at_word(r, 1, node) && number_at(r, 2, "a count", UINT64_MAX - 1, &item->k) &&
           number_at(r, 3, PICOSECONDS, MOST_PS, &item->later);
}

static bool read_message(struct reader *r)
{
    uint32_t node = 0;
    struct plan_item item = {0};
    if (!read_delay(r, &node, &item))
        return false;
    if (item.later)
        append(&r->plan->node[node].messages, item);
    return true;
}

static bool read_interrupt(struct reader *r)
{
    uint32_t node = 0;
    struct plan_item item = {0};
    if (!read_delay(r, &node, &item))
        return false;
    if (item.later)
        append(&r->plan->node[node].interrupts, item);
    return true;
}

static bool has_use(struct reader *r)
{
    const struct plan *p = r->plan;
    return p->orders || p->delays ||
           fail(r,
                "%s: a line must say before whether such lines must be kept, 'orders', or only tell of a "
                "run, 'delays'",
                r->word[0]);
}

static bool read_match(struct reader *r)
{
    uint32_t node = 0;
    struct plan_item item = {.line = r->line};
    if (!has_use(r) || !node_at_word(r, 1, &node) ||
        !number_at(r, 2, "a count of receives", UINT64_MAX - 1, &item.k) || !node_at_word(r, 3, &item.from) ||
        !number_at(r, 4, "a count of messages", UINT64_MAX - 1, &item.nth))
        return false;
    if (r->plan->orders)
        append(&r->plan->node[node].matches, item);
    return true;
}

static bool read_handler(struct reader *r)
{
    uint32_t node = 0;
    struct plan_item item = {.line = r->line};
    if (!has_use(r) || !node_at_word(r, 1, &node) ||
        !number_at(r, 2, "a count of handlers", UINT64_MAX - 1, &item.k) ||
        !number_at(r, 3, "a count of calls", UINT64_MAX - 1, &item.calls))
        return false;
    if (r->plan->orders)
        append(&r->plan->node[node].handlers, item);
    return true;
}

/* It tells of a message that no receive got. */
static bool read_left(struct reader *r)
{
    uint32_t node, from;
    uint64_t nth;
    return node_at_word(r, 1, &node) && node_at_word(r, 2, &from) &&
           number_at(r, 3, "a count of messages", UINT64_MAX - 1, &nth);
}

static const struct line_kind {
    const char *name;
    int words;
    const char *form;
    bool (*read)(struct reader *r);
} LINES[] = {{"nodes", 2, "nodes COUNT", read_nodes},
             {"program", 2, "program NUMBER", read_program},
             {"orders", 1, "orders", read_use},
             {"delays", 1, "delays", read_use},
             {"speed", 3, "speed NODE PPM", read_speed},
             {"start", 3, "start NODE PICOSECONDS", read_start},
             {"message", 4, "message NODE K PICOSECONDS", read_message},
             {"interrupt", 4, "interrupt NODE K PICOSECONDS", read_interrupt},
             {"match", 5, "match NODE K FROM J", read_match},
             {"handler", 4, "handler NODE K CALLS", read_handler},
             {"left", 4, "left NODE FROM J", read_left}};

static bool read_words(struct reader *r)
{
    if (!r->begun)
        return read_format(r);
    for (size_t i = 0; i < sizeof LINES / sizeof *LINES; i++) {
        const struct line_kind *kind = &LINES[i];
        if (strcmp(r->word[0], kind->name))
            continue;
        return r->words == kind->words ? kind->read(r) : fail(r, "such a line is '%s'", kind->form);
    }
    return fail(r, "a schedule has no lines '%s'", r->word[0]);
}

/* Takes a line apart: its words up to a comment. Those with '=' tell, and are not read. */
static bool read_line(struct reader *r, char *line)
{
    line[strcspn(line, "#")] = '\0';
    char *rest = NULL;
    r->words = 0;
    for (char *w = strtok_r(line, " \t\r", &rest); w && !strchr(w, '='); w = strtok_r(NULL, " \t\r", &rest)) {
        if (r->words == MOST_WORDS)
            return fail(r, "there are too many words: '%s'", w);
        r->word[r->words++] = w;
    }
    return r->words == 0 || read_words(r);
}

/* --- the whole --- */

static bool finish(struct reader *r)
{
    struct plan *p = r->plan;
    if (!r->begun)
        return read_format(r);
    if (!p->node)
        return fail(r, "there is no line 'nodes COUNT'");
    unsigned twice = plan_sort(p);
    if (!twice)
        return true;
    r->line = twice;
    return fail(r, TWICE);
}

static bool read_text(struct reader *r, char *text)
{
    for (char *line; (line = strsep(&text, "\n"));) {
        r->line++;
        if (!read_line(r, line))
            return false;
    }
    return finish(r);
}

struct plan *plan_read(const char *path, char **error)
{
    const char *why;
    int line;
    char *text = text_file_read(path, MOST_BYTES, &why, &line);
    if (!text) {
        *error =
            line ? xasprintf("%s:%d: %s", path, line, why) : xasprintf("%s cannot be read: %s", path, why);
        return NULL;
    }
    struct reader r = {.plan = xcalloc(1, sizeof *r.plan)};
    r.plan->path = xstrdup(path);
    bool good = read_text(&r, text);
    free(text);
    if (good)
        return r.plan;
    *error = r.error;
    plan_free(r.plan);
    return NULL;
}
