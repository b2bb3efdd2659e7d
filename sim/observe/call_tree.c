/* call_tree.c - see call_tree.h. The nodes' trees of paths are laid over each other: a body of the program is
 * the same on all nodes if it lies at the same distance from the program's start. */
#include "observe/call_tree.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "guest/image.h"
#include "kernel/xalloc.h"
#include "lp/clock.h"
#include "nx_api/contract/program_image.h"
#include "profile/path_times.h"

/* Stands for what is computed in functions compiled without --profile. */
static const char REST[] = "(compiled without --profile)";
/* Stands for the computing of programs that another program's end stopped: their counts may go beyond that
 * moment. */
static const char CUT[] = "(in programs cut short)";
static const char HANDLERS[] = "(handlers)", WAITING[] = "(waiting)";

bool call_tree_possible(const struct node *n)
{
    return n->guest.image && n->guest.image->bodies_begin != n->guest.image->bodies_end;
}

/* --- spots and shares --- */

static bool same_text(const char *a, const char *b)
{
    return a == b || strcmp(a, b) == 0;
}

/* The child that a description describes, made if there is none. */
static uint32_t child(struct call_tree *t, uint32_t parent, const struct spot *what)
{
    for (uint32_t i = t->spots[parent].children; i; i = t->spots[i].next) {
        const struct spot *s = &t->spots[i];
        if (s->kind == what->kind && s->body == what->body && s->line == what->line &&
            same_text(s->name, what->name) && same_text(s->file, what->file))
            return i;
    }
    if (t->spot_count == t->spot_room) {
        t->spot_room *= 2;
        t->spots = xreallocarray(t->spots, t->spot_room, sizeof *t->spots);
    }
    uint32_t i = t->spot_count++;
    t->spots[i] = *what;
    t->spots[i].parent = parent;
    t->spots[i].next = t->spots[parent].children;
    return t->spots[parent].children = i;
}

static uint32_t named_child(struct call_tree *t, uint32_t parent, enum spot_kind kind, const char *name)
{
    return child(t, parent, &(struct spot){.kind = kind, .name = name, .file = ""});
}

static uint32_t share_at(struct call_tree *t, uint32_t spot, const char *file, int32_t line, bool computing)
{
    for (uint32_t i = t->spots[spot].first_share; i; i = t->shares[i - 1].next) {
        const struct share *s = &t->shares[i - 1];
        if (s->line == line && s->computing == computing && same_text(s->file, file))
            return i - 1;
    }
    if (t->share_count == t->share_room) {
        t->share_room = t->share_room ? 2 * t->share_room : 64;
        t->shares = xreallocarray(t->shares, t->share_room, sizeof *t->shares);
    }
    t->shares[t->share_count] = (struct share){.spot = spot,
                                               .file = file,
                                               .line = line,
                                               .computing = computing,
                                               .next = t->spots[spot].first_share,
                                               .units = xcalloc(t->nodes, sizeof(int64_t)),
                                               .time = xcalloc(t->nodes, sizeof(vtime))};
    t->spots[spot].first_share = ++t->share_count;
    return t->share_count - 1;
}

/* --- the program's tables --- */

/* A program may have overwritten its tables. */
static const char *text_of(const struct node *n, const struct nxc_cell *cells, int32_t text)
{
    const char *s = (const char *)cells + text;
    return !text ? "" : s >= n->guest.program && s < n->guest.program + n->guest.image_bytes ? s : "?";
}

static const struct nxc_cell *cells_of(const struct nxc_body *b)
{
    return (const struct nxc_cell *)((const char *)b + b->cells);
}

static const struct nxc_weight *weights_of(const struct nxc_body *b)
{
    return (const struct nxc_weight *)((const char *)b + b->weights);
}

/* The same body in the first node's program. */
static const struct nxc_body *first_nodes(const struct machine *m, const struct node *n,
                                          const struct nxc_body *b)
{
    return (const struct nxc_body *)(m->sys.nodes[0]->guest.program + ((const char *)b - n->guest.program));
}

/* The spot of a function that is the function of a spot, or inlined into it. */
static uint32_t function_spot(struct call_tree *t, const struct node *n, uint32_t spot,
                              const struct nxc_body *b, int32_t cell)
{
    const struct nxc_cell *cells = cells_of(b), *c = &cells[cell];
    if (c->parent < 0 || cell == b->cell)
        return spot;
    struct spot s = {.kind = SPOT_INLINED,
                     .name = text_of(n, cells, c->function),
                     .file = text_of(n, cells, c->file),
                     .line = c->line};
    return child(t, function_spot(t, n, spot, b, c->parent), &s);
}

/* Finds the share of each weight of a spot's body. */
static void find_shares(struct call_tree *t, const struct node *n, uint32_t spot, const struct nxc_body *b)
{
    const struct nxc_cell *cells = cells_of(b);
    uint32_t *shares = xcalloc((size_t)b->weight_count + 1, sizeof *shares);
    for (int32_t i = 0; i < b->weight_count; i++) {
        const struct nxc_cell *c = &cells[weights_of(b)[i].cell];
        uint32_t at = function_spot(t, n, spot, b, c->parent);
        if (c->called)
            at = named_child(t, at, SPOT_LIBRARY, text_of(n, cells, c->called));
        shares[i] = share_at(t, at, text_of(n, cells, c->file), c->line, true);
    }
    t->spots[spot].shares = shares;
}

/* --- computing --- */

static uint32_t path_spot(struct call_tree *t, const struct machine *m, const struct node *n, uint32_t parent,
                          const struct nxc_path *p)
{
    const struct nxc_body *b = first_nodes(m, n, p->body);
    const struct node *first = m->sys.nodes[0];
    const struct nxc_cell *cells = cells_of(b), *c = &cells[b->cell];
    struct spot s = {.kind = SPOT_FUNCTION,
                     .name = text_of(first, cells, c->function),
                     .file = text_of(first, cells, c->file),
                     .line = c->line,
                     .body = b};
    uint32_t spot = child(t, parent, &s);
    if (!t->spots[spot].shares)
        find_shares(t, first, spot, b);
    return spot;
}

/* Adds what was computed on the paths below p, which is at a spot; returns the units. */
static int64_t add_paths(struct call_tree *t, const struct machine *m, const struct node *n, uint32_t spot,
                         const struct nxc_path *p)
{
    int64_t sum = 0;
    for (const struct nxc_path *q = p->children; q; q = q->next) {
        uint32_t at = path_spot(t, m, n, spot, q);
        const struct nxc_weight *w = weights_of(t->spots[at].body);
        for (int32_t i = 0; i < q->body->weight_count; i++) {
            int64_t units = w[i].units * q->counts[w[i].slot];
            t->shares[t->spots[at].shares[i]].units[n->id] += units;
            sum += units;
        }
        sum += add_paths(t, m, n, at, q);
    }
    return sum;
}

static void add_computing(struct call_tree *t, const struct machine *m, const struct node *n)
{
    int64_t rest = (int64_t)n->lp.clock.units;
    if (!n->end.cut_short) {
        rest -= add_paths(t, m, n, 0, n->guest.image->root);
        const struct node_path_times *times = path_times_of(n);
        if (times->handlers.children)
            rest -= add_paths(t, m, n, named_child(t, 0, SPOT_OTHER, HANDLERS), &times->handlers);
    }
    if (rest) {
        uint32_t spot = named_child(t, 0, SPOT_OTHER, n->end.cut_short ? CUT : REST);
        uint32_t share = share_at(t, spot, "", 0, true); /* may move t->shares */
        t->shares[share].units[n->id] = rest;
    }
}

/* A node's shares take the time of their units. What a sum of units takes is not always the sum of what they
 * take in whole picoseconds: then the shares behind have the rest. */
static void take_time(struct call_tree *t, const struct node *n)
{
    int64_t units = 0;
    for (uint32_t i = 0; i < t->share_count; i++) {
        struct share *s = &t->shares[i];
        if (!s->computing)
            continue;
        vtime before = clock_of_units(&n->lp, (uint64_t)units);
        units += s->units[n->id];
        s->time[n->id] = clock_of_units(&n->lp, (uint64_t)units) - before;
    }
}

/* --- system time and waits --- */

static uint32_t spot_of(struct call_tree *t, const struct machine *m, const struct node *n,
                        const struct nxc_path *p)
{
    if (!p || p == n->guest.image->root)
        return 0;
    if (p == &path_times_of(n)->handlers)
        return named_child(t, 0, SPOT_OTHER, HANDLERS);
    return path_spot(t, m, n, spot_of(t, m, n, p->parent), p);
}

/* A place with its spot's names, by which places are sorted: the order in which they came is the engine's. */
struct named_place {
    const struct path_time *place;
    char *name;
};

static void write_name(const struct nxc_path *p, FILE *f)
{
    if (!p || !p->body)
        return;
    write_name(p->parent, f);
    fprintf(f, "%s;", (const char *)cells_of(p->body) + cells_of(p->body)[p->body->cell].function);
}

static char *name_of(const struct path_time *p)
{
    char *text;
    size_t length;
    FILE *f = xchecked(open_memstream(&text, &length));
    write_name(p->path, f);
    fprintf(f, "%s", p->call);
    fclose(f);
    return text;
}

static int by_place_name(const void *a, const void *b)
{
    const struct named_place *x = a, *y = b;
    return strcmp(x->name, y->name);
}

static void add_time(struct call_tree *t, uint32_t spot, const struct node *n, vtime time)
{
    uint32_t share = share_at(t, spot, "", 0, false);
    t->shares[share].time[n->id] += time;
}

static void add_place(struct call_tree *t, const struct machine *m, const struct node *n,
                      const struct path_time *p)
{
    if (!p->system && !p->idle)
        return;
    uint32_t above = spot_of(t, m, n, p->path);
    uint32_t call = named_child(t, above, *p->call == '(' ? SPOT_OTHER : SPOT_CALL, p->call);
    if (p->system)
        add_time(t, call, n, p->system);
    if (p->idle)
        add_time(t, named_child(t, call, SPOT_WAITING, WAITING), n, p->idle);
}

static void add_places(struct call_tree *t, const struct machine *m, const struct node *n)
{
    const struct node_path_times *times = path_times_of(n);
    struct named_place *sorted = xcalloc(times->count + 1, sizeof *sorted);
    for (size_t i = 0; i < times->count; i++)
        sorted[i] = (struct named_place){&times->list[i], name_of(&times->list[i])};
    qsort(sorted, times->count, sizeof *sorted, by_place_name);
    for (size_t i = 0; i < times->count; i++) {
        add_place(t, m, n, sorted[i].place);
        free(sorted[i].name);
    }
    free(sorted);
}

struct call_tree call_tree_collect(const struct machine *m)
{
    struct call_tree t = {.nodes = m->sys.count, .spot_room = 64, .spot_count = 1};
    t.spots = xcalloc(t.spot_room, sizeof *t.spots);
    t.spots[0] = (struct spot){.kind = SPOT_ROOT, .name = "", .file = ""};
    for (uint32_t k = 0; k < t.nodes; k++)
        add_computing(&t, m, m->sys.nodes[k]);
    for (uint32_t k = 0; k < t.nodes; k++) {
        take_time(&t, m->sys.nodes[k]);
        add_places(&t, m, m->sys.nodes[k]);
    }
    return t;
}

void call_tree_free(struct call_tree *t)
{
    for (uint32_t i = 0; i < t->spot_count; i++)
        free(t->spots[i].shares);
    for (uint32_t i = 0; i < t->share_count; i++) {
        free(t->shares[i].units);
        free(t->shares[i].time);
    }
    free(t->spots);
    free(t->shares);
}
