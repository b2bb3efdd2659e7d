/* time_profile.c - see time_profile.h. */
#include "observe/time_profile.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "lp/clock.h"
#include "nx_api/contract/program_image.h"

bool profile_possible(const struct machine *m)
{
    return call_tree_possible(m->sys.nodes[0]);
}

static enum profile_class class_of(const struct node *n)
{
    return n->handlers.armed ? PROFILE_ARMED : PROFILE_OTHERS;
}

/* --- functions --- */

static int compare_texts(const char *a, const char *b)
{
    return a == b ? 0 : !a ? -1 : !b ? 1 : strcmp(a, b);
}

/* The cost units that an ordinary node counts while a node with a clock of its own counts units. */
static int64_t ordinary_units(const struct node *n, int64_t units)
{
    uint64_t hz = n->sys->cfg->clock_hz;
    return n->lp.clock_hz == hz ? units
                                : (int64_t)((__int128)units * (__int128)hz / (__int128)n->lp.clock_hz);
}

/* The function of a share's spot; for a library function, who has called it. */
static struct profile_function function_of(const struct call_tree *t, const struct share *share)
{
    const struct spot *s = &t->spots[share->spot];
    const char *called = s->kind == SPOT_LIBRARY ? s->name : NULL;
    if (called)
        s = &t->spots[s->parent];
    return (struct profile_function){.file = s->file, .function = s->name, .called = called, .line = s->line};
}

static int by_name(const void *a, const void *b)
{
    const struct profile_function *x = a, *y = b;
    int order = compare_texts(x->file, y->file);
    order = order ? order : compare_texts(x->function, y->function);
    order = order ? order : (x->line > y->line) - (x->line < y->line);
    return order ? order : compare_texts(x->called, y->called);
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

/* Adds up neighbours with one name. */
static void unite(struct profile *p)
{
    size_t n = 0;
    for (size_t i = 0; i < p->function_count; i++) {
        if (n == 0 || by_name(&p->functions[n - 1], &p->functions[i])) {
            p->functions[n++] = p->functions[i];
            continue;
        }
        for (int c = 0; c < PROFILE_CLASSES; c++)
            p->functions[n - 1].units[c] += p->functions[i].units[c];
    }
    p->function_count = n;
}

static void collect_functions(struct profile *p, const struct machine *m)
{
    const struct call_tree *t = &p->tree;
    p->functions = xcalloc(t->share_count + 1, sizeof *p->functions);
    for (uint32_t i = 0; i < t->share_count; i++) {
        if (!t->shares[i].computing)
            continue;
        struct profile_function *f = &p->functions[p->function_count++];
        *f = function_of(t, &t->shares[i]);
        for (uint32_t k = 0; k < t->nodes; k++)
            f->units[class_of(m->sys.nodes[k])] += ordinary_units(m->sys.nodes[k], t->shares[i].units[k]);
    }
    qsort(p->functions, p->function_count, sizeof *p->functions, by_name);
    unite(p);
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
    vtime_sum left = x->idle[0] + x->idle[1], right = y->idle[0] + y->idle[1];
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
    p.tree = call_tree_collect(m);
    collect_functions(&p, m);
    for (uint32_t k = 0; k < m->sys.count; k++)
        add_times(&p, m->sys.nodes[k]);
    for (int c = 0; c < PROFILE_CLASSES; c++) {
        struct profile_times *t = &p.times[c];
        t->rest = profile_node_time(&p, c) - t->computing - t->system - t->idle;
    }
    if (p.idle)
        qsort(p.idle, p.idle_count, sizeof *p.idle, longest_first);
    return p;
}

void profile_free(struct profile *p)
{
    free(p->functions);
    free(p->idle);
    call_tree_free(&p->tree);
}

vtime_sum profile_node_time(const struct profile *p, enum profile_class c)
{
    return (vtime_sum)p->end * p->times[c].nodes;
}

double profile_seconds(const struct profile *p, int64_t units)
{
    return (double)units / (double)p->units_per_second;
}
