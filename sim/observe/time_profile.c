/* time_profile.c - see time_profile.h. All nodes have the same cells; those of node 0 give the names. */
#include "observe/time_profile.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "lp/clock.h"
#include "guest/image.h"
#include "nx_api/contract/program_image.h"

/* Stands for the functions compiled without --profile. */
static const char REST[] = "(compiled without --profile)";
/* Stands for the functions of programs that another program's end stopped while computing: their cells may
 * count beyond that moment. */
static const char CUT[] = "(in programs cut short)";

static size_t cell_count(const struct node *n)
{
    return (size_t)(n->image->cells_end - n->image->cells_begin);
}

bool profile_possible(const struct machine *m)
{
    return cell_count(m->sys.nodes[0]) > 0;
}

static enum profile_class class_of(const struct node *n)
{
    return n->armed ? PROFILE_ARMED : PROFILE_OTHERS;
}

/* --- functions --- */

static int compare_texts(const char *a, const char *b)
{
    return a == b ? 0 : !a ? -1 : !b ? 1 : strcmp(a, b);
}

static int by_name(const void *a, const void *b)
{
    const struct nxc_cell *x = *(struct nxc_cell *const *)a, *y = *(struct nxc_cell *const *)b;
    int order = compare_texts(x->file, y->file);
    order = order ? order : compare_texts(x->function, y->function);
    order = order ? order : (x->line > y->line) - (x->line < y->line);
    return order ? order : compare_texts(x->called, y->called);
}

/* The names in node 0's cells. */
struct names {
    struct nxc_cell *cells;
    size_t count;
    size_t *entry; /* of each cell: its index in profile.functions */
};

static bool is_in_program(const struct node *n, const void *p)
{
    return (uintptr_t)p - (uintptr_t)n->program < n->image_bytes;
}

/* The cells are in the program's memory. If the program has overwritten a name's address, the name is "?". */
static void copy_names(struct names *names, const struct node *n)
{
    names->count = cell_count(n);
    names->cells = xcalloc(names->count, sizeof *names->cells);
    names->entry = xcalloc(names->count, sizeof *names->entry);
    for (size_t k = 0; k < names->count; k++) {
        struct nxc_cell *c = &names->cells[k];
        *c = n->image->cells_begin[k];
        c->file = is_in_program(n, c->file) ? c->file : "?";
        c->function = is_in_program(n, c->function) ? c->function : "?";
        c->called = !c->called || is_in_program(n, c->called) ? c->called : "?";
        size_t body = (size_t)(c->body - n->image->cells_begin);
        c->body = c->body && body < names->count ? &names->cells[body] : NULL;
    }
}

/* Makes an entry of the profile for each name. */
static void name_functions(struct profile *p, struct names *names)
{
    struct nxc_cell **sorted = xcalloc(names->count, sizeof(struct nxc_cell *));
    p->functions = xcalloc(names->count + 2, sizeof *p->functions);
    for (size_t k = 0; k < names->count; k++)
        sorted[k] = &names->cells[k];
    qsort(sorted, names->count, sizeof *sorted, by_name);
    for (size_t k = 0; k < names->count; k++) {
        const struct nxc_cell *c = sorted[k];
        if (k == 0 || by_name(&sorted[k - 1], &sorted[k]))
            p->functions[p->function_count++] = (struct profile_function){
                .file = c->file, .function = c->function, .called = c->called, .line = c->line};
        names->entry[c - names->cells] = p->function_count - 1;
    }
    free(sorted);
}

/* The cost units that an ordinary node counts while a node with a clock of its own counts units. */
static int64_t ordinary_units(const struct node *n, int64_t units)
{
    uint64_t hz = n->sys->cfg->clock_hz;
    return n->lp.clock_hz == hz ? units
                                : (int64_t)((__int128)units * (__int128)hz / (__int128)n->lp.clock_hz);
}

/* Adds the node's cost units to the entries; returns their sum. */
static int64_t add_functions(struct profile *p, const struct node *n, const struct names *names)
{
    enum profile_class c = class_of(n);
    int64_t sum = 0;
    for (size_t k = 0; k < names->count; k++) {
        const struct nxc_cell *body = names->cells[k].body;
        int64_t units = ordinary_units(n, n->image->cells_begin[k].units);
        p->functions[names->entry[k]].units[c] += units;
        if (body)
            p->functions[names->entry[body - names->cells]].units[c] -= units;
        else
            sum += units;
    }
    return sum;
}

static int64_t units_of(const struct profile_function *f)
{
    return f->units[PROFILE_OTHERS] + f->units[PROFILE_ARMED];
}

static int dearest_first(const void *a, const void *b)
{
    const struct profile_function *x = a, *y = b;
    int order = (units_of(y) > units_of(x)) - (units_of(y) < units_of(x));
    order = order ? order : compare_texts(x->file, y->file);
    order = order ? order : compare_texts(x->function, y->function);
    return order ? order : compare_texts(x->called, y->called);
}

static void collect_functions(struct profile *p, const struct machine *m)
{
    struct profile_function rest = {.file = "", .function = REST}, cut = {.file = "", .function = CUT};
    struct names names;
    copy_names(&names, m->sys.nodes[0]);
    name_functions(p, &names);
    for (uint32_t k = 0; k < m->sys.count; k++) {
        const struct node *n = m->sys.nodes[k];
        int64_t units = ordinary_units(n, (int64_t)n->lp.clock.units);
        if (n->cut_short)
            cut.units[class_of(n)] += units;
        else
            rest.units[class_of(n)] += units - add_functions(p, n, &names);
    }
    free(names.cells);
    free(names.entry);
    if (rest.units[PROFILE_OTHERS] || rest.units[PROFILE_ARMED])
        p->functions[p->function_count++] = rest;
    p->functions[p->function_count++] = cut;
    qsort(p->functions, p->function_count, sizeof *p->functions, dearest_first);
    while (p->function_count > 0 && units_of(&p->functions[p->function_count - 1]) == 0)
        p->function_count--; /* these functions never ran */
}

/* --- time outside of functions --- */

static struct profile_idle *idle_in(struct profile *p, const char *call)
{
    for (size_t i = 0; i < p->idle_count; i++)
        if (!strcmp(p->idle[i].call, call))
            return &p->idle[i];
    p->idle = xreallocarray(p->idle, p->idle_count + 1, sizeof *p->idle);
    p->idle[p->idle_count] = (struct profile_idle){.call = call};
    return &p->idle[p->idle_count++];
}

static int longest_first(const void *a, const void *b)
{
    const struct profile_idle *x = a, *y = b;
    vtime left = x->idle[0] + x->idle[1], right = y->idle[0] + y->idle[1];
    return left != right ? (right > left) - (right < left) : strcmp(x->call, y->call);
}

static void add_times(struct profile *p, const struct node *n)
{
    enum profile_class c = class_of(n);
    struct profile_times *t = &p->times[c];
    t->nodes++;
    t->computing += clock_of_units(&n->lp, n->lp.clock.units);
    t->system += n->times.system;
    t->idle += n->stats.idle;
    t->beside += n->stats.overlapped;
    for (int i = 0; i < NODE_TASKS; i++)
        t->tasks[i] += n->times.tasks[i];
    for (size_t i = 0; i < n->stats.waits.count; i++) {
        const struct node_wait *w = &n->stats.waits.list[i];
        struct profile_idle *idle = idle_in(p, w->call);
        idle->idle[c] += w->idle;
        idle->waits[c] += w->waits;
    }
}

struct profile profile_collect(const struct machine *m)
{
    struct profile p = {.end = m->end, .units_per_second = m->sys.cfg->clock_hz * NXC_UNITS_PER_CLOCK};
    collect_functions(&p, m);
    for (uint32_t k = 0; k < m->sys.count; k++)
        add_times(&p, m->sys.nodes[k]);
    for (int c = 0; c < PROFILE_CLASSES; c++) {
        struct profile_times *t = &p.times[c];
        t->rest = (int64_t)(profile_node_time(&p, c) - t->computing - t->system - t->idle);
    }
    if (p.idle)
        qsort(p.idle, p.idle_count, sizeof *p.idle, longest_first);
    return p;
}

void profile_free(struct profile *p)
{
    free(p->functions);
    free(p->idle);
}

vtime profile_node_time(const struct profile *p, enum profile_class c)
{
    return p->end * p->times[c].nodes;
}

double profile_seconds(const struct profile *p, int64_t units)
{
    return (double)units / (double)p->units_per_second;
}
