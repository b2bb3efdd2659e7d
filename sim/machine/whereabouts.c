/* whereabouts.c - see whereabouts.h. */
#include "machine/whereabouts.h"
#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "files/number_ranges.h"
#include "files/virtual_time.h"
#include "guest/backtrace.h"
#include "kernel/xalloc.h"
#include "lp/clock.h"
#include "machine/crash.h"
#include "machine/standstill.h"
#include "nx_api/contract/program_image.h"
#include "nx_api/waitfor/waitfor.h"
#include "os/end.h"

/* More nodes are grouped by their states. */
enum { MOST_ALONE = 16 };
/* A loop is named that has had such a part of the node's time. */
enum { LEAST_LOOP = 10 };

/* What a program does; two that do the same have equal text, line and kind. */
struct where {
    char text[64];    /* "crecv(7)", "computing" ... */
    const char *line; /* of the source; NULL: not known */
    bool timed;       /* `since` is part of it: since then in the call */
    bool ended;       /* or ended at that time */
    vtime since;
};

/* Nodes in the same state. */
struct group {
    struct where where;
    vtime latest; /* where.since is the earliest */
    uint32_t *nodes, count;
};

/* Has the run been stopped, or asked, from outside, at a moment that differs from run to run? All other
 * reports must be equal in every run. */
static bool is_from_outside(enum stop stop)
{
    return stop == STOP_NOT || stop == STOP_WALL_TIME || stop == STOP_INTERRUPTED;
}

/* The line of a program whose fiber a signal has ended. */
static const char *line_of_crash(const struct node *n, struct backtrace_lines *lines)
{
    uintptr_t calls[sizeof n->cold->crash->frames / sizeof(uintptr_t)];
    memcpy(calls, n->cold->crash->frames, sizeof calls);
    calls[0]++; /* as if a call returned there */
    return backtrace_line_of(lines, n, calls, n->cold->crash->depth);
}

/* The source line in which a node's program is; NULL if it is not known. At a limit of virtual time, a
 * computing program's line is that of its last slice boundary: the program may have computed past the limit
 * before it was known that the system takes time from it. */
static const char *line_of(const struct node *n, struct backtrace_lines *lines)
{
    const enum stop stop = n->sys->schedule.stop;
    if (n->lp.state == LP_ENDED)
        return node_exited_badly(n) ? backtrace_line_of(lines, n, n->cold->exit_calls, NODE_EXIT_CALLS)
                                    : NULL;
    if (is_from_outside(stop) && n->cold->crash)
        return line_of_crash(n, lines);
    if (is_from_outside(stop) && !n->call.name && n->guest.image && !fiber_frame(&n->lp.fiber) &&
        !n->wait.at_poll)
        return backtrace_line_at(lines, n, (uintptr_t)n->guest.image->main + 1); /* it has not begun */
    if (stop == STOP_NOT && n->sys->running && !n->wait.at_poll)
        return backtrace_line_away(lines, n);
    if (n->call.name)
        return n->lp.state == LP_BLOCKED || n->call.since == VT_NEVER ? backtrace_line(lines, n) : NULL;
    if (stop == STOP_VIRTUAL_TIME)
        return backtrace_line_of(lines, n, (uintptr_t[]){clock_last_place(&n->lp)}, 1);
    if (n->wait.at_poll)
        return backtrace_line(lines, n);
    return is_from_outside(stop) ? backtrace_line_away(lines, n) : NULL;
}

/* Since when a node's program has been in one loop without a call, at least; VT_NEVER: not for a tenth of its
 * time. (Else a loop that is just under way would be named in each report of a program that computes.) System
 * time within the loop is left out: the engines learn of it at different times. */
static vtime in_loop_since(const struct node *n)
{
    const struct schedule *s = &n->sys->schedule;
    if (s->stop != STOP_VIRTUAL_TIME && !is_from_outside(s->stop))
        return VT_NEVER;
    vtime time = clock_time_in_loop(&n->lp);
    vtime now = s->stop == STOP_VIRTUAL_TIME ? s->stop_at.time : n->lp.clock.now;
    return time && time >= now / LEAST_LOOP ? now - time : VT_NEVER;
}

static struct where where_is(const struct node *n, struct backtrace_lines *lines)
{
    struct where w = {.line = line_of(n, lines), .since = n->call.since};
    const char *handler = n->in_handler ? " in a handler" : "";
    if (n->end.how == NODE_NOT_LOADED) {
        snprintf(w.text, sizeof w.text, "no program");
    } else if (n->lp.state == LP_ENDED) {
        if (node_exited_badly(n))
            snprintf(w.text, sizeof w.text, "ended with exit(%d)", n->end.exit_code);
        else
            snprintf(w.text, sizeof w.text, "ended");
        w.ended = true, w.since = n->stats.ended_at;
    } else if (!n->call.name) {
        w.since = in_loop_since(n);
        w.timed = w.since != VT_NEVER;
        snprintf(w.text, sizeof w.text, "computing%s%s", w.timed ? " in one loop, without a call," : "",
                 handler);
    } else if (n->call.since == VT_NEVER) {
        snprintf(w.text, sizeof w.text, "before %s%s", n->call.name, handler);
    } else {
        const char *operation = n->call.awaits ? waitfor_operation(n->call.awaited) : NULL;
        w.timed = true;
        if (operation)
            snprintf(w.text, sizeof w.text, "%s%s", operation, handler);
        else if (n->call.has_type)
            snprintf(w.text, sizeof w.text, "%s(%ld)%s", n->call.name, n->call.type, handler);
        else
            snprintf(w.text, sizeof w.text, "%s%s", n->call.name, handler);
    }
    return w;
}

static void print_where(FILE *f, const struct where *w, vtime latest)
{
    fprintf(f, "%s", w->text);
    if (w->timed || w->ended)
        fprintf(f, " %s %s", w->ended ? "at" : "since", virtual_time_moment(w->since).text);
    if ((w->timed || w->ended) && latest != w->since)
        fprintf(f, " to %s", virtual_time_moment(latest).text);
    if (w->line)
        fprintf(f, " (%s)", w->line);
}

static void print_node(FILE *f, const struct node *n, struct backtrace_lines *lines)
{
    struct where w = where_is(n, lines);
    fprintf(f, "%s: ", n->cold->name);
    print_where(f, &w, w.since);
}

/* --- groups --- */

static int compare_lines(const char *a, const char *b)
{
    return a && b ? strcmp(a, b) : (a != NULL) - (b != NULL);
}

/* 0: the same state. */
static int compare(const void *a, const void *b)
{
    const struct where *x = &((const struct group *)a)->where, *y = &((const struct group *)b)->where;
    int order = strcmp(x->text, y->text);
    order = order ? order : compare_lines(x->line, y->line);
    order = order ? order : x->timed - y->timed;
    return order ? order : x->ended - y->ended;
}

static void join(struct group *g, uint32_t node, const struct where *w)
{
    g->where.since = vt_min(g->where.since, w->since);
    g->latest = vt_max(g->latest, w->since);
    g->nodes = xreallocarray(g->nodes, g->count + 1, sizeof *g->nodes);
    g->nodes[g->count++] = node;
}

/* In the order of their first nodes. */
struct groups {
    void *tree; /* of tsearch */
    struct group **list;
    size_t count;
};

static struct group *group_of(struct groups *g, const struct where *w)
{
    const struct group key = {.where = *w};
    struct group **found = tfind(&key, &g->tree, compare);
    if (found)
        return *found;
    struct group *made = xcalloc(1, sizeof *made);
    *made = (struct group){.where = *w, .latest = w->since};
    xchecked(tsearch(made, &g->tree, compare));
    g->list = xreallocarray(g->list, g->count + 1, sizeof *g->list);
    return g->list[g->count++] = made;
}

static void free_group(void *group)
{
    free(((struct group *)group)->nodes);
    free(group);
}

static void print_groups(FILE *f, const struct node_system *s, struct backtrace_lines *lines)
{
    struct groups groups = {0};
    for (uint32_t i = 0; i < s->count; i++) {
        struct where w = where_is(s->nodes[i], lines);
        join(group_of(&groups, &w), i, &w);
    }
    for (size_t k = 0; k < groups.count; k++) {
        const struct group *g = groups.list[k];
        fprintf(f, "\n  ");
        number_ranges_print_nodes(f, g->nodes, g->count);
        fprintf(f, ": ");
        print_where(f, &g->where, g->latest);
    }
    tdestroy(groups.tree, free_group);
    free(groups.list);
}

static char *describe(const struct node_system *s, const char *what, uint32_t most_alone)
{
    char *text;
    size_t size;
    struct backtrace_lines *lines = backtrace_lines_new();
    FILE *f = xchecked(open_memstream(&text, &size));
    fprintf(f, "%s", what);
    if (s->host) {
        fprintf(f, "\n  ");
        print_node(f, s->host, lines);
    }
    for (uint32_t i = 0; s->count <= most_alone && i < s->count; i++) {
        fprintf(f, "\n  ");
        print_node(f, s->nodes[i], lines);
    }
    if (s->count > most_alone)
        print_groups(f, s, lines);
    standstill_print(f, s, lines, "\n  ");
    backtrace_lines_free(lines);
    fclose(f);
    return text;
}

char *whereabouts(const struct node_system *s, const char *what)
{
    return describe(s, what, MOST_ALONE);
}

char *whereabouts_grouped(const struct node_system *s, const char *what)
{
    return describe(s, what, 0);
}

char *whereabouts_of(const struct node *n)
{
    char *text;
    size_t size;
    struct backtrace_lines *lines = backtrace_lines_new();
    FILE *f = xchecked(open_memstream(&text, &size));
    print_node(f, n, lines);
    backtrace_lines_free(lines);
    fclose(f);
    return text;
}
