/* waitfor_print.c - types and nodes as people read them. */
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
    const char *between = "";
    fputs("one of the types ", f);
    for (int i = 0; i <= ABOVE_MASK; i++)
        if (typesel >> i & 1) {
            fprintf(f, "%s%d%s", between, i, i == ABOVE_MASK ? " and above" : "");
            between = ", ";
        }
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

/* The first from i on that is chosen; w->count: none. */
static uint32_t next_chosen(const struct waitfor *w, uint32_t i, waitfor_choice *is, const void *arg)
{
    while (i < w->count && !is(w, i, arg))
        i++;
    return i;
}

/* The first from i on that is not, or is the host. */
static uint32_t end_of_run(const struct waitfor *w, uint32_t i, waitfor_choice *is, const void *arg)
{
    while (i < w->count && !w->nodes[i].is_host && is(w, i, arg))
        i++;
    return i;
}

static void print_run(FILE *f, uint32_t first, uint32_t end)
{
    fprintf(f, "%u", first);
    if (end - first > 1)
        fprintf(f, "%s%u", end - first > 2 ? "-" : ", ", end - 1);
}

void waitfor_print_nodes(FILE *f, const struct waitfor *w, waitfor_choice *is, const void *arg)
{
    uint32_t i = next_chosen(w, 0, is, arg);
    bool host = w->count && w->nodes[w->count - 1].is_host && is(w, w->count - 1, arg);
    uint32_t nodes_end = w->count - (w->count && w->nodes[w->count - 1].is_host);
    if (i == w->count)
        fputs("none", f);
    else if (i < nodes_end)
        fputs(next_chosen(w, i + 1, is, arg) < nodes_end ? "nodes " : "node ", f);
    for (const char *between = ""; i < nodes_end; between = ", ") {
        uint32_t end = end_of_run(w, i, is, arg);
        fputs(between, f);
        print_run(f, i, end);
        i = next_chosen(w, end, is, arg);
    }
    if (host)
        fprintf(f, "%sthe host", next_chosen(w, 0, is, arg) < nodes_end ? " and " : "");
}
