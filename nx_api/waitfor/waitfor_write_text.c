/* waitfor_write_text.c - a report for people. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/waitfor/waitfor_parts.h"

enum { MOST_IN_CYCLE = 24, MOST_GROUPS = 12, MOST_FRAMES = 8 };

/* Nodes in the same state, of the same cause. */
struct group {
    const struct waitfor_node *first;
    long least, most; /* of the types that they wait for */
    uint64_t earliest, latest;
    bool same_why;
    bool told; /* its remedy */
};

struct groups {
    struct group *all;
    uint32_t *of; /* of each node: its group */
    uint32_t count;
};

/* --- grouping --- */

static int compare_texts(const char *a, const char *b)
{
    return a && b ? strcmp(a, b) : (a != NULL) - (b != NULL);
}

static int compare_numbers(long a, long b)
{
    return (a > b) - (a < b);
}

static int compare_stacks(const struct waitfor_node *a, const struct waitfor_node *b)
{
    int order = compare_numbers((long)a->stack_count, (long)b->stack_count);
    for (size_t i = 0; !order && i < a->stack_count; i++)
        order = compare_texts(a->stack[i], b->stack[i]);
    return order;
}

static const char *name_of_call(const struct waitfor_node *n)
{
    return n->operation ? n->operation : n->call;
}

/* 0: in the same state, of the same cause; but for the type that they wait for, if that is all the same. */
static int compare_states(const struct waitfor_node *a, const struct waitfor_node *b, bool any_type)
{
    int order = compare_numbers(a->state, b->state);
    order = order ? order : compare_numbers(a->exit_status, b->exit_status);
    order = order ? order : compare_numbers(a->is_host, b->is_host);
    order = order ? order : compare_texts(name_of_call(a), name_of_call(b));
    if (!a->operation && !b->operation) {
        order = order ? order : compare_numbers(a->has_type, b->has_type);
        order = order || any_type ? order : compare_numbers(a->type, b->type);
    }
    order = order ? order : compare_texts(a->line, b->line);
    order = order ? order : compare_numbers(a->cause, b->cause);
    return order ? order : compare_stacks(a, b);
}

static int compare(const void *a, const void *b, void *any_type)
{
    const struct waitfor_node *one = *(const struct waitfor_node *const *)a,
                              *other = *(const struct waitfor_node *const *)b;
    int order = compare_states(one, other, *(const bool *)any_type);
    return order ? order : compare_numbers(one->number, other->number);
}

static bool same_text(const char *a, const char *b)
{
    return compare_texts(a, b) == 0;
}

static void join(struct group *g, const struct waitfor_node *n)
{
    g->earliest = n->since_ps < g->earliest ? n->since_ps : g->earliest;
    g->latest = n->since_ps > g->latest ? n->since_ps : g->latest;
    g->least = n->type < g->least ? n->type : g->least;
    g->most = n->type > g->most ? n->type : g->most;
    g->same_why = g->same_why && same_text(g->first->why, n->why);
}

/* The order of groups is that of their first nodes. */
static struct groups group(const struct waitfor *w, bool any_type)
{
    struct groups g = {.all = waitfor_alloc(w->count, sizeof *g.all),
                       .of = waitfor_alloc(w->count, sizeof *g.of)};
    const struct waitfor_node **sorted = waitfor_alloc(w->count, sizeof *sorted);
    uint32_t *first = waitfor_alloc(w->count, sizeof *first); /* of the nodes in the same state */
    for (uint32_t i = 0; i < w->count; i++)
        sorted[i] = &w->nodes[i];
    qsort_r(sorted, w->count, sizeof *sorted, compare, &any_type);
    for (uint32_t i = 0; i < w->count; i++) {
        bool same = i && compare_states(sorted[i - 1], sorted[i], any_type) == 0;
        first[sorted[i]->number] = same ? first[sorted[i - 1]->number] : (uint32_t)sorted[i]->number;
    }
    for (uint32_t i = 0; i < w->count; i++) {
        const struct waitfor_node *n = &w->nodes[i];
        if (first[i] == i)
            g.all[g.count] = (struct group){n, n->type, n->type, n->since_ps, n->since_ps, true, false};
        g.of[i] = first[i] == i ? g.count++ : g.of[first[i]];
        join(&g.all[g.of[i]], n);
    }
    free(first);
    free(sorted);
    return g;
}

static void free_groups(const struct groups *g)
{
    free(g->all);
    free(g->of);
}

/* --- lines --- */

struct member {
    const uint32_t *of;
    uint32_t group;
};

static bool is_member(const struct waitfor *w, uint32_t i, const void *arg)
{
    const struct member *m = arg;
    (void)w;
    return m->of[i] == m->group;
}

static void print_state(FILE *f, const struct group *g)
{
    const struct waitfor_node *n = g->first;
    if (n->state == WAITFOR_NO_PROGRAM)
        fputs("no program", f);
    else if (n->state == WAITFOR_ENDED)
        waitfor_print_ended(f, n);
    else if (n->state == WAITFOR_COMPUTES)
        fputs("computing", f);
    else if (n->has_type && !n->operation && g->least < g->most)
        fprintf(f, "%s of types %ld to %ld", n->call, g->least, g->most);
    else if (n->has_type && !n->operation)
        fprintf(f, "%s(%ld)", n->call, n->type);
    else
        fputs(name_of_call(n), f);
}

static void print_times(FILE *f, const struct group *g)
{
    if (g->first->state != WAITFOR_WAITS && g->first->state != WAITFOR_ENDED)
        return;
    fprintf(f, " %s ", g->first->state == WAITFOR_ENDED ? "at" : "since");
    waitfor_print_time(f, g->earliest);
    if (g->latest == g->earliest)
        return;
    fputs(" to ", f);
    waitfor_print_time(f, g->latest);
}

static void print_stack(FILE *f, const struct waitfor_node *n)
{
    if (n->stack_count < 2)
        return;
    fputs("\n    in ", f);
    for (size_t i = 0; i < n->stack_count && i < MOST_FRAMES; i++)
        fprintf(f, "%s%s", i ? ", called from " : "", n->stack[i]);
    fputs(n->stack_count > MOST_FRAMES ? ", ..." : "", f);
}

/* Below one another. */
static void print_lines(FILE *f, const char *text)
{
    for (; text && *text; text++) {
        fputc(*text, f);
        fputs(*text == '\n' ? "      " : "", f);
    }
}

static void print_cause(FILE *f, const struct group *g)
{
    if (g->first->state != WAITFOR_WAITS)
        return;
    fprintf(f, "\n    %s: ", waitfor_cause_name(g->first->cause));
    if (!g->same_why)
        fprintf(f, "for example %s: ", g->first->name);
    print_lines(f, g->first->why);
}

/* What groups before it have told is not told again. */
static void print_remedy(FILE *f, struct groups *g, uint32_t k)
{
    const char *remedy = g->all[k].first->remedy;
    for (uint32_t i = 0; i < g->count; i++)
        if (g->all[i].told && remedy == g->all[i].first->remedy)
            return;
    g->all[k].told = true;
    if (remedy)
        fprintf(f, "\n    %s", remedy);
}

static void print_group(FILE *f, const struct waitfor *w, struct groups *g, uint32_t k)
{
    const struct group *one = &g->all[k];
    fputs("  ", f);
    if (one->first->is_host)
        fputs(one->first->name, f);
    else
        waitfor_print_nodes(f, w, is_member, &(struct member){g->of, k});
    fputs(": ", f);
    print_state(f, one);
    print_times(f, one);
    if (one->first->line)
        fprintf(f, " (%s)", one->first->line);
    print_stack(f, one->first);
    print_cause(f, one);
    print_remedy(f, g, k);
}

static void print_cycle(FILE *f, const struct waitfor *w)
{
    for (uint32_t k = 0; k < w->cycle_count && k < MOST_IN_CYCLE; k++) {
        waitfor_print_node(f, w, w->cycle[k]);
        fputs(" -> ", f);
    }
    if (w->cycle_count > MOST_IN_CYCLE)
        fprintf(f, "... (%u more) -> ", w->cycle_count - MOST_IN_CYCLE);
    waitfor_print_node(f, w, w->cycle[0]);
}

static bool is_in_knot(const struct waitfor *w, uint32_t i, const void *arg)
{
    (void)arg;
    return w->nodes[i].state == WAITFOR_WAITS && w->nodes[i].cause == WAITFOR_KNOT;
}

/* The cycle or the knot, if one of the two is there. */
static void print_head(FILE *f, const struct waitfor *w)
{
    if (w->cycle) {
        fputs("  cycle: ", f);
        print_cycle(f, w);
        /* in_circle counts the cycle that is printed, if it is among the circles */
        fputs(w->circles > w->nodes[w->cycle[0]].in_circle ? ", one of several\n" : "\n", f);
        return;
    }
    for (uint32_t i = 0; i < w->count; i++)
        if (is_in_knot(w, i, NULL)) {
            fputs("  knot: ", f);
            waitfor_print_nodes(f, w, is_in_knot, NULL);
            fputs(" wait for messages that only they could send\n", f);
            return;
        }
}

/* The host is the last node, and the first of the list. */
static void print_groups(FILE *f, const struct waitfor *w, struct groups *g)
{
    const struct group *last = &g->all[g->count - 1];
    bool host = last->first->is_host;
    if (host)
        print_group(f, w, g, g->count - 1);
    for (uint32_t k = 0; k < g->count - host && k < MOST_GROUPS; k++) {
        fputs(k || host ? "\n" : "", f);
        print_group(f, w, g, k);
    }
    if (g->count - host > MOST_GROUPS)
        fprintf(f, "\n  and %u more states of nodes, which the report as JSON has",
                g->count - host - MOST_GROUPS);
}

void waitfor_write_text(const struct waitfor *w, FILE *f)
{
    struct groups g = group(w, false);
    if (g.count > MOST_GROUPS) { /* nodes that each wait for a type of their own are one line */
        free_groups(&g);
        g = group(w, true);
    }
    print_head(f, w);
    print_groups(f, w, &g);
    free_groups(&g);
}
