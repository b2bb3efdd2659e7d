/* tally.c - see tally.h. */
#include "lab/why/tally.h"
#include <search.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

static int by_label(const void *a, const void *b)
{
    return strcmp(((const struct tally_row *)a)->label, ((const struct tally_row *)b)->label);
}

void tally_add(struct tally *t, const char *label, vtime time)
{
    struct tally_row key = {.label = label}, **found = tfind(&key, &t->tree, by_label);
    if (!found) {
        struct tally_row *row = xcalloc(1, sizeof *row);
        row->label = label;
        found = xchecked(tsearch(row, &t->tree, by_label));
        t->count++;
    }
    (*found)->time += time;
    (*found)->count++;
}

static int by_time(const void *a, const void *b)
{
    const struct tally_row *x = a, *y = b;
    if (x->time != y->time)
        return x->time > y->time ? -1 : 1;
    return strverscmp(x->label, y->label); /* node 2 before node 10 */
}

static void collect(const void *node, VISIT which, void *closure)
{
    struct tally *t = closure;
    if (which == postorder || which == leaf)
        t->rows[t->count++] = **(struct tally_row *const *)node;
}

void tally_sort(struct tally *t)
{
    t->rows = xreallocarray(NULL, t->count + 1, sizeof *t->rows);
    t->count = 0;
    twalk_r(t->tree, collect, t);
    tdestroy(t->tree, free);
    t->tree = NULL;
    qsort(t->rows, t->count, sizeof *t->rows, by_time);
}

void tally_free(struct tally *t)
{
    tdestroy(t->tree, free);
    free(t->rows);
    *t = (struct tally){0};
}

int tally_longest(const vtime_sum *times, int count, bool *told)
{
    int longest = -1;
    for (int i = 0; i < count; i++)
        if (!told[i] && times[i] && (longest < 0 || times[i] > times[longest]))
            longest = i;
    if (longest >= 0)
        told[longest] = true;
    return longest;
}
