/* race_report.c - see race_report.h. A race of two lines and one variable is one race, on whichever nodes
 * and by whichever of the lines' accesses it was found. */
#include "observe/race_report.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "races/node_races.h"
#include "observe/race_suppress.h"
#include "observe/race_texts.h"

static struct race_report_side side_of(struct race_texts *t, const struct node_races *r,
                                       const struct race_side *s, const char **variable)
{
    const struct race_place *p = race_places_at(r->places, s->place);
    struct race_report_side out = {.reads = !s->write,
                                   .writes = s->write,
                                   .in_handler = s->in_handler,
                                   .call = p->call ? race_text(t, p->call) : NULL,
                                   .at = s->at,
                                   .posted = {.function = "", .file = ""}};
    out.depth = race_text_of_place(t, r, s->place, out.frames, variable);
    if (!p->posted)
        return out;
    struct race_frame posted[RACE_MOST_FRAMES];
    const char *none;
    race_text_of_place(t, r, p->posted, posted, &none);
    const char *call = race_places_at(r->places, p->posted)->call;
    out.posted = posted[0];
    out.posted_by = call ? race_text(t, call) : "hrecv";
    return out;
}

/* Of two accesses the handler's comes first, of a buffer and an access the buffer's call. */
static bool is_first(const struct race_finding *f, const struct race_side *s)
{
    return f->what > RACE_OF_UPDATE ? s == &f->earlier : s->in_handler;
}

static struct race_report report_of(struct race_texts *t, const struct node_races *r,
                                    const struct race_finding *f, size_t nodes)
{
    const struct race_side *first = is_first(f, &f->earlier) ? &f->earlier : &f->later;
    const struct race_side *second = first == &f->earlier ? &f->later : &f->earlier;
    const char *variable, *other;
    struct race_report out = {
        .what = f->what, .count = f->count, .node = race_text(t, r->name), .nodes = nodes};
    out.file = r->file, out.offset = f->offset;
    out.side[0] = side_of(t, r, first, &variable);
    out.side[1] = side_of(t, r, second, &other);
    out.first_came_later = first == &f->later;
    out.variable = *other ? other : *variable ? variable : race_text_of_data(t, r->file, f->offset);
    for (int i = 1; i >= 0 && !*out.variable; i--)
        out.variable = race_text_given(t, r, &out.side[i].frames[0]);
    return out;
}

/* --- merging --- */

/* The length of a variable's name without members and indices. */
static size_t base_length(const char *variable)
{
    return strcspn(variable, "[.-(");
}

static int compare_frames(const struct race_frame *a, const struct race_frame *b)
{
    int c = strcmp(a->file, b->file);
    c = c ? c : (a->line > b->line) - (a->line < b->line);
    return c ? c : strcmp(a->function, b->function);
}

static int compare_variables(const char *a, const char *b)
{
    size_t x = base_length(a), y = base_length(b);
    int c = strncmp(a, b, x < y ? x : y);
    return c ? c : (x > y) - (x < y);
}

static int compare_sides(const struct race_report_side *a, const struct race_report_side *b)
{
    int c = compare_frames(&a->frames[0], &b->frames[0]);
    c = c ? c : a->in_handler - b->in_handler;
    return c ? c : strcmp(a->call ? a->call : "", b->call ? b->call : "");
}

/* Equal: they are instances of one race. In the order of the source. */
static int compare_races(const void *left, const void *right)
{
    const struct race_report *a = left, *b = right;
    int c = compare_sides(&a->side[1], &b->side[1]);
    c = c ? c : compare_sides(&a->side[0], &b->side[0]);
    c = c ? c : compare_variables(a->variable, b->variable);
    return c ? c : (a->what > b->what) - (a->what < b->what);
}

static vtime when(const struct race_report *r)
{
    return r->side[r->first_came_later ? 0 : 1].at;
}

/* Instances of one race in the order of time; nodes and their findings are in order already. */
static int compare(const void *left, const void *right)
{
    const struct race_report *a = left, *b = right;
    int c = compare_races(a, b);
    c = c ? c : (when(a) > when(b)) - (when(a) < when(b));
    return c ? c : (a->order > b->order) - (a->order < b->order);
}

/* Nodes are noted of each race, not of each finding: all of a large machine's may have found it. */
static void note_nodes(struct race_report *r)
{
    r->on_node = xcalloc(r->nodes, sizeof *r->on_node);
    r->on_node[r->first_number] = true;
}

static void add_instance(struct race_report *to, const struct race_report *r)
{
    to->count += r->count;
    for (int i = 0; i < 2; i++) {
        to->side[i].reads |= r->side[i].reads;
        to->side[i].writes |= r->side[i].writes;
    }
    to->on_node[r->first_number] = true;
}

/* The list is sorted. Returns how many are left. */
static size_t merge(struct race_report *list, size_t count)
{
    size_t left = 0;
    for (size_t i = 0; i < count; i++)
        if (left && compare_races(&list[left - 1], &list[i]) == 0)
            add_instance(&list[left - 1], &list[i]);
        else
            list[left] = list[i], note_nodes(&list[left++]);
    return left;
}

static void suppress(struct race_reports *t, const struct race_suppressions *s)
{
    size_t left = 0;
    for (size_t i = 0; i < t->count; i++)
        if (race_suppress_matches(s, &t->list[i]))
            free(t->list[i].on_node);
        else
            t->list[left++] = t->list[i];
    t->suppressed = t->count - left;
    t->count = left;
}

/* --- groups --- */

bool race_report_is_of_buffer(const struct race_report *r)
{
    return r->what == RACE_ON_SEND || r->what == RACE_ON_RECEIVE || r->what == RACE_OF_BUFFERS;
}

/* A variable's name in what the source says of it: "*block", "block[0]". */
static const char *name_in(const char *variable)
{
    return variable + strspn(variable, "*&(");
}

/* Are the races of one variable? object: the static one that the memory is of, "": none; then the variable is
 * known by its name in a function. (Texts that are equal are one.) */
static bool are_of_one(const struct race_report *a, const char *object, const struct race_report *b,
                       const char *other)
{
    const struct race_frame *at = &a->side[1].frames[0], *at_other = &b->side[1].frames[0];
    if (*object || *other)
        return object == other;
    return a->file == b->file && at->function == at_other->function && at->file == at_other->file &&
           *a->variable && compare_variables(name_in(a->variable), name_in(b->variable)) == 0;
}

static void group(struct race_reports *t)
{
    const char **object = xcalloc(t->count, sizeof *object);
    for (size_t i = 0, k; i < t->count; i++) {
        struct race_report *r = &t->list[i];
        object[i] = race_text_of_data(t->texts, r->file, r->offset);
        for (k = 0; k < i && !are_of_one(&t->list[k], object[k], r, object[i]);)
            k++;
        r->group = k;
        t->groups += k == i;
    }
    free(object);
}

/* --- collecting --- */

static size_t components(const struct races *all)
{
    size_t most = 0;
    for (const struct node_races *r = all->nodes; r; r = r->next)
        most = r->number + 1 > most ? r->number + 1 : most;
    return most;
}

static void add_node(struct race_reports *t, const struct node_races *r, size_t nodes)
{
    const struct race_findings *f = &r->findings;
    t->checked = true;
    t->dropped += f->dropped;
    if (f->count < 2)
        return;
    t->list = xreallocarray(t->list, t->count + f->count, sizeof *t->list);
    for (uint32_t i = 1; i < f->count; i++) {
        if (!f->list[i].count)
            continue;
        struct race_report *new = &t->list[t->count];
        *new = report_of(t->texts, r, &f->list[i], nodes);
        new->first_number = r->number, new->order = t->count++;
    }
}

struct race_reports *race_reports_collect(const struct races *all, const struct race_suppressions *s)
{
    struct race_reports *t = xcalloc(1, sizeof *t);
    size_t nodes = components(all);
    t->texts = race_texts_new();
    for (const struct node_races *r = all->nodes; r; r = r->next)
        add_node(t, r, nodes);
    if (t->count) {
        qsort(t->list, t->count, sizeof *t->list, compare);
        t->count = merge(t->list, t->count);
        suppress(t, s);
        group(t);
    }
    return t;
}

void race_reports_free(struct race_reports *t)
{
    for (size_t i = 0; i < t->count; i++)
        free(t->list[i].on_node);
    free(t->list);
    race_texts_free(t->texts);
    free(t);
}
