/* plan.c - see plan.h. */
#include "timing/plan.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

static int by_k(const void *a, const void *b)
{
    uint64_t x = ((const struct plan_item *)a)->k, y = ((const struct plan_item *)b)->k;
    return (x > y) - (x < y);
}

/* If a sorted list has two equal items, *twice is the line of the second. */
static void note_twice(const struct plan_list *l, int (*compare)(const void *, const void *), unsigned *twice)
{
    for (size_t i = 1; i < l->count; i++) {
        unsigned line = l->item[i].line, before = l->item[i - 1].line;
        if (compare(&l->item[i], &l->item[i - 1]) == 0)
            *twice = line > before ? line : before;
    }
}

static void sort(struct plan_list *l, unsigned *twice)
{
    if (l->count)
        qsort(l->item, l->count, sizeof *l->item, by_k);
    note_twice(l, by_k, twice);
}

static int by_message(const void *a, const void *b)
{
    const struct plan_item *x = a, *y = b;
    return x->from != y->from ? (x->from > y->from) - (x->from < y->from)
                              : (x->nth > y->nth) - (x->nth < y->nth);
}

/* The same matches by their messages; if two are of one message, *twice is the line of the second. */
static void sort_by_message(struct plan_node *n, unsigned *twice)
{
    struct plan_list *l = &n->by_message;
    if (!n->matches.count)
        return;
    l->count = n->matches.count;
    l->item = xreallocarray(NULL, l->count, sizeof *l->item);
    memcpy(l->item, n->matches.item, l->count * sizeof *l->item);
    qsort(l->item, l->count, sizeof *l->item, by_message);
    note_twice(l, by_message, twice);
}

const struct plan_item *plan_find(const struct plan_list *l, uint64_t k)
{
    const struct plan_item item = {.k = k};
    return l->count ? bsearch(&item, l->item, l->count, sizeof item, by_k) : NULL;
}

const struct plan_item *plan_find_message(const struct plan_list *l, uint32_t from, uint64_t nth)
{
    const struct plan_item item = {.from = from, .nth = nth};
    return l->count ? bsearch(&item, l->item, l->count, sizeof item, by_message) : NULL;
}

unsigned plan_sort(struct plan *p)
{
    unsigned twice = 0;
    for (uint32_t i = 0; i <= p->nodes; i++) {
        struct plan_node *n = &p->node[i];
        sort(&n->messages, &twice);
        sort(&n->interrupts, &twice);
        sort(&n->matches, &twice);
        sort(&n->handlers, &twice);
        sort_by_message(n, &twice);
    }
    return twice;
}

void plan_free(struct plan *p)
{
    if (!p)
        return;
    for (uint32_t i = 0; p->node && i <= p->nodes; i++) {
        free(p->node[i].messages.item);
        free(p->node[i].interrupts.item);
        free(p->node[i].matches.item);
        free(p->node[i].handlers.item);
        free(p->node[i].by_message.item);
    }
    free(p->node);
    free(p->path);
    free(p);
}
