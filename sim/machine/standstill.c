/* standstill.c - see standstill.h. */
#include "machine/standstill.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "files/number_ranges.h"
#include "files/virtual_time.h"
#include "kernel/xalloc.h"
#include "node/system.h"
#include "os/end.h"

/* Shares of a node's time, and of a window of it. */
static const double LEAST_WINDOW = 0.1, LEAST_POLLS = 0.5, LEAST_HANDLERS = 0.8;

/* --- one node --- */

/* A node's end, or its present time if the run has not ended. */
static vtime present(const struct node *n)
{
    bool ended = n->lp.state == LP_ENDED || n->sys->schedule.stop != STOP_NOT;
    return ended ? n->stats.ended_at : vt_max(n->stats.ended_at, n->lp.clock.now);
}

static double part(vtime t, vtime of)
{
    return of == 0 ? 0 : t >= of ? 1 : (double)t / (double)of;
}

static double share_of_polls(const struct livelock_poll *p, vtime now)
{
    return p->count && now > p->since ? part(p->spent, now - p->since) : 0;
}

static bool polls(const struct livelock *l, vtime now, struct standstill *s)
{
    double all = 0, most = 0;
    *s = (struct standstill){.until = now, .goes_on = true};
    for (int i = 0; i < LIVELOCK_POLLS; i++) {
        const struct livelock_poll *p = &l->polls[i];
        double share = share_of_polls(p, now);
        all += share;
        if (share > most)
            most = share, s->poll = p;
    }
    if (!s->poll || s->poll->count < STANDSTILL_POLLS || all < LEAST_POLLS ||
        part(now - s->poll->since, now) < LEAST_WINDOW)
        return false;
    s->since = s->poll->since, s->count = s->poll->count;
    s->share = most, s->others = all - most;
    return true;
}

static const struct livelock_handler *most_time(const struct livelock_siege *s)
{
    const struct livelock_handler *most = &s->by[0];
    for (uint32_t i = 1; i < s->kinds; i++)
        if (s->by[i].time > most->time)
            most = &s->by[i];
    return most;
}

static bool handlers(const struct livelock *l, vtime now, struct standstill *s)
{
    const struct livelock_siege *g = l->siege.stood >= l->worst.stood ? &l->siege : &l->worst;
    vtime until = vt_min(g->until, now);
    *s = (struct standstill){.since = g->since, .until = until, .count = g->handlers};
    if (g->handlers < STANDSTILL_HANDLERS || until <= g->since || part(until - g->since, now) < LEAST_WINDOW)
        return false;
    s->share = part(g->stood, until - g->since);
    s->handler = most_time(g);
    s->goes_on = g == &l->siege && 2 * g->stood >= now - g->since;
    return s->share >= LEAST_HANDLERS;
}

/* Has the program come to its end by itself? Then it has come further than its last polls. */
static bool is_over(const struct node *n)
{
    return n->lp.state == LP_ENDED && (n->end.how == NODE_RETURNED || n->end.how == NODE_EXITED);
}

bool standstill_of(const struct node *n, struct backtrace_lines *lines, struct standstill *s)
{
    const struct livelock *l = livelock_of(n);
    if (!l)
        return false;
    vtime now = present(n);
    if (!is_over(n) && polls(l, now, s))
        s->line = backtrace_line_of(lines, n, s->poll->places, LIVELOCK_PLACES);
    else if (handlers(l, now, s))
        s->line = backtrace_line_at(lines, n, (uintptr_t)s->handler->handler + 1);
    else
        return false;
    return true;
}

/* --- nodes that do the same --- */

struct alike {
    struct standstill first;
    double least, most; /* share */
    uint64_t fewest, greatest;
    vtime shortest, longest, earliest;
    uint32_t *nodes, count;
};

static bool is_same_line(const char *a, const char *b)
{
    return a && b ? strcmp(a, b) == 0 : a == b;
}

static bool is_alike(const struct standstill *a, const struct standstill *b)
{
    if (!is_same_line(a->line, b->line) || !a->poll != !b->poll || a->goes_on != b->goes_on)
        return false;
    if (a->poll)
        return strcmp(a->poll->call, b->poll->call) == 0 && a->poll->asks == b->poll->asks &&
               a->poll->select.type == b->poll->select.type && a->poll->select.node == b->poll->select.node;
    return a->handler->sends == b->handler->sends && a->handler->type == b->handler->type;
}

static void join(struct alike *a, uint32_t node, const struct standstill *s)
{
    vtime t = s->until - s->since;
    if (!a->count)
        *a = (struct alike){*s, s->share, s->share, s->count, s->count, t, t, s->since, NULL, 0};
    a->least = s->share < a->least ? s->share : a->least;
    a->most = s->share > a->most ? s->share : a->most;
    a->fewest = s->count < a->fewest ? s->count : a->fewest;
    a->greatest = s->count > a->greatest ? s->count : a->greatest;
    a->shortest = vt_min(t, a->shortest), a->longest = vt_max(t, a->longest);
    a->earliest = vt_min(s->since, a->earliest);
    a->nodes = xreallocarray(a->nodes, a->count + 1, sizeof *a->nodes);
    a->nodes[a->count++] = node;
}

/* --- text --- */

/* Of two numbers that look the same, one is printed. */
static void print_percent(FILE *f, double least, double most)
{
    char a[40], b[40];
    snprintf(a, sizeof a, "%.1f", least);
    snprintf(b, sizeof b, "%.1f", most);
    fprintf(f, strcmp(a, b) == 0 ? "%s" : "%s to %s", a, b);
}

static void print_counts(FILE *f, const struct alike *a)
{
    fprintf(f, "%" PRIu64, a->fewest);
    if (a->fewest != a->greatest)
        fprintf(f, " to %" PRIu64, a->greatest);
}

static void print_poll(FILE *f, const struct livelock_poll *p)
{
    fprintf(f, "%s", p->call);
    if (!p->asks)
        return;
    if (strstr(p->call, "msgdone"))
        fprintf(f, " of a receive of type %" PRId64, p->select.type);
    else
        fprintf(f, "(%" PRId64 ")", p->select.type);
    if (p->select.node >= 0)
        fprintf(f, " from node %ld", p->select.node);
}

static bool has_come(const struct node_system *s, int64_t type)
{
    uint32_t hash = node_type_hash(type);
    return s->types_come[hash / 64] >> hash % 64 & 1;
}

static void print_durations(FILE *f, const struct alike *a)
{
    struct time_text shortest = duration_text(vt_seconds(a->shortest)),
                     longest = duration_text(vt_seconds(a->longest));
    fprintf(f, "%s", shortest.text);
    if (strcmp(shortest.text, longest.text))
        fprintf(f, " to %s", longest.text);
}

static void print_polls(FILE *f, const struct node_system *s, const struct alike *a)
{
    const struct livelock_poll *p = a->first.poll;
    fprintf(f, " poll%s: ", a->count > 1 ? "" : "s");
    print_percent(f, 100 * a->least, 100 * a->most);
    fprintf(f, " %% of the last ");
    print_durations(f, a);
    fprintf(f, " in ");
    print_poll(f, p);
    if (a->first.line)
        fprintf(f, " (%s)", a->first.line);
    fprintf(f, ", ");
    print_counts(f, a);
    fprintf(f, p->asks ? " times without an answer" : " times, and no message or handler came");
    if (a->first.others >= 0.01)
        fprintf(f, "; and %.1f %% in other polls", 100 * a->first.others);
    if (p->asks && p->select.type >= 0 && !has_come(s, p->select.type))
        fprintf(f, "; no message of %s %" PRId64 " has come to any node",
                strncmp(p->call, "MPI_", 4) == 0 ? "tag" : "type", p->select.type);
    const struct node *bad = node_bad_exit(s);
    if (bad)
        fprintf(f, "; look at %s first, which ended with exit(%d)", bad->cold->name, bad->end.exit_code);
}

static void print_handlers(FILE *f, const struct alike *a)
{
    const struct livelock_handler *h = a->first.handler;
    fprintf(f, " stand%s still: %" PRIu64, a->count > 1 ? "" : "s", a->fewest);
    if (a->fewest != a->greatest)
        fprintf(f, " to %" PRIu64, a->greatest);
    fprintf(f, " handlers%s of ", a->first.count > h->count ? ", most" : "");
    if (h->sends)
        fprintf(f, "hsend");
    else
        fprintf(f, "hrecv(%" PRId64 ")", h->type);
    if (a->first.line)
        fprintf(f, " (%s)", a->first.line);
    fprintf(f, a->first.count > h->count ? ", take " : " take ");
    print_percent(f, 100 * a->least, 100 * a->most);
    fprintf(f, a->first.goes_on ? " %% of the time since %s" : " %% of the time from %s",
            virtual_time_moment(a->earliest).text);
    if (!a->first.goes_on) {
        fprintf(f, " on, for ");
        print_durations(f, a);
    }
}

static void print(FILE *f, const struct node_system *s, const struct alike *a)
{
    if (a->nodes[0] == s->count)
        fprintf(f, "host");
    else
        number_ranges_print_nodes(f, a->nodes, a->count);
    if (a->first.poll)
        print_polls(f, s, a);
    else
        print_handlers(f, a);
}

struct kinds {
    struct alike *list;
    size_t count;
};

/* The host is alike nobody. */
static void add(struct kinds *k, const struct node *n, struct backtrace_lines *lines)
{
    struct standstill s;
    size_t i = 0;
    if (!standstill_of(n, lines, &s))
        return;
    while (i < k->count && (n->is_host || !is_alike(&k->list[i].first, &s)))
        i++;
    if (i == k->count) {
        k->list = xreallocarray(k->list, ++k->count, sizeof *k->list);
        k->list[i] = (struct alike){0};
    }
    join(&k->list[i], n->is_host ? n->sys->count : n->id, &s);
}

void standstill_print(FILE *f, const struct node_system *s, struct backtrace_lines *lines, const char *before)
{
    struct kinds k = {0};
    for (uint32_t i = 0; i < s->count; i++)
        add(&k, s->nodes[i], lines);
    if (s->host)
        add(&k, s->host, lines);
    for (size_t i = 0; i < k.count; i++) {
        fprintf(f, "%s", before);
        print(f, s, &k.list[i]);
        free(k.list[i].nodes);
    }
    free(k.list);
}
