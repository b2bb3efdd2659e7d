/* waitfor_print.c - types and nodes as people read them. */
#include <stdlib.h>
#include "nx_api/waitfor/waitfor_parts.h"

enum { LAST_IN_MASK = 29, ABOVE_MASK = 30 };

bool waitfor_type_selected(long typesel, long type)
{
    if (typesel >= 0)
        return typesel == type;
    if (waitfor_operation(type))
        return false;
    return typesel == -1 || (typesel >> (type <= LAST_IN_MASK ? type : ABOVE_MASK) & 1);
}

bool waitfor_selects(const struct waitfor_select *s, long type, long from, long pid)
{
    return waitfor_type_selected(s->typesel, type) && (s->node < 0 || s->node == from) &&
           (s->pid < 0 || s->pid == pid);
}

/* A negative typesel is a set: bit i selects type i, bit 30 all from 30 on. */
static void print_set(FILE *f, long typesel)
{
    const char *between = "one of the types ";
    bool any = false;
    for (int i = 0; i <= ABOVE_MASK; i++)
        if (typesel >> i & 1) {
            fprintf(f, "%s%d%s", between, i, i == ABOVE_MASK ? " and above" : "");
            between = ", ";
            any = true;
        }
    if (!any)
        fputs("no type", f);
}

void waitfor_print_typesel(FILE *f, long typesel)
{
    if (typesel >= 0)
        fprintf(f, "type %ld", typesel);
    else if (typesel == -1)
        fputs("any type", f);
    else
        print_set(f, typesel);
}

void waitfor_print_node(FILE *f, const struct waitfor *w, long node)
{
    if (node == WAITFOR_ANY)
        fputs("any node", f);
    else if (node >= 0 && node < (long)w->count && w->nodes[node].is_host)
        fputs("the host", f);
    else
        fprintf(f, "node %ld", node);
}

void waitfor_print_ended(FILE *f, const struct waitfor_node *n)
{
    fputs("ended", f);
    if (n->exit_status)
        fprintf(f, " with exit(%d)", n->exit_status);
}

void waitfor_print_time(FILE *f, uint64_t ps)
{
    static const struct {
        const char *name;
        double ps;
        int digits; /* behind the point */
    } UNITS[] = {{"s", 1e12, 9}, {"ms", 1e9, 6}, {"us", 1e6, 3}, {"ns", 1e3, 3}};
    char number[24];
    int i = 0;
    while (i < 3 && ps && (double)ps < UNITS[i].ps)
        i++;
    size_t length =
        (size_t)snprintf(number, sizeof number, "%.*f", UNITS[i].digits, (double)ps / UNITS[i].ps);
    while (number[length - 1] == '0')
        length--;
    length -= number[length - 1] == '.';
    fprintf(f, "%.*s %s", (int)length, number, UNITS[i].name);
}

/* --- sets of nodes --- */

struct waitfor_set waitfor_choose(const struct waitfor *w, waitfor_choice *is, const void *arg)
{
    struct waitfor_set s = {.host = WAITFOR_ANY};
    bool before = false; /* is the node before in the last run? */
    for (uint32_t i = 0; i < w->count; i++) {
        bool in = is(w, i, arg), node = in && !w->nodes[i].is_host;
        if (in && !node)
            s.host = i;
        if (node && !before) {
            s.runs = waitfor_room(s.runs, s.run_count, sizeof *s.runs);
            s.runs[s.run_count++].first = i;
        }
        if (node)
            s.runs[s.run_count - 1].end = i + 1;
        s.nodes += node;
        before = node;
    }
    return s;
}

static bool is_one(struct waitfor_run r)
{
    return r.end - r.first == 1;
}

/* How many runs from the first on are single nodes at equal distances. */
static uint32_t in_step(const struct waitfor_run *r, uint32_t count)
{
    uint32_t n = 1;
    while (n < count && is_one(r[0]) && is_one(r[n]) &&
           r[n].first - r[n - 1].first == r[1].first - r[0].first)
        n++;
    return n;
}

/* "1-5, 7", "2, 4, ..., 510"; at most MOST_RUNS of these. */
static void print_runs(FILE *f, const struct waitfor_run *r, uint32_t count)
{
    enum { MOST_RUNS = 12, STEPS = 5 };
    uint32_t shown = 0, k = 0, left = 0;
    while (k < count && shown++ < MOST_RUNS) {
        uint32_t steps = in_step(r + k, count - k);
        fprintf(f, "%s%u", k ? ", " : "", r[k].first);
        if (steps >= STEPS) {
            fprintf(f, ", %u, ..., %u", r[k + 1].first, r[k + steps - 1].first);
            k += steps;
        } else {
            if (!is_one(r[k]))
                fprintf(f, "%s%u", r[k].end - r[k].first > 2 ? "-" : ", ", r[k].end - 1);
            k++;
        }
    }
    for (; k < count; k++)
        left += r[k].end - r[k].first;
    if (left)
        fprintf(f, " and %u more", left);
}

void waitfor_print_set(FILE *f, const struct waitfor_set *s, long but)
{
    bool host = s->host != WAITFOR_ANY && s->host != but;
    uint32_t nodes = s->nodes - (but != WAITFOR_ANY && but != s->host), count = 0;
    struct waitfor_run *runs = waitfor_alloc(s->run_count + 1, sizeof *runs);
    for (uint32_t k = 0; k < s->run_count; k++) {
        struct waitfor_run r = s->runs[k];
        bool parted = r.first <= but && but < r.end;
        struct waitfor_run parts[] = {{r.first, parted ? (uint32_t)but : r.end},
                                      {parted ? (uint32_t)but + 1 : r.end, r.end}};
        for (int i = 0; i < 2; i++)
            if (parts[i].first < parts[i].end)
                runs[count++] = parts[i];
    }
    if (nodes)
        fputs(nodes > 1 ? "nodes " : "node ", f);
    print_runs(f, runs, count);
    free(runs);
    if (host)
        fprintf(f, "%sthe host", nodes ? " and " : "");
    else if (!nodes)
        fputs("none", f);
}

void waitfor_print_nodes(FILE *f, const struct waitfor *w, waitfor_choice *is, const void *arg)
{
    struct waitfor_set s = waitfor_choose(w, is, arg);
    waitfor_print_set(f, &s, WAITFOR_ANY);
    free(s.runs);
}
