/* delays.c - see delays.h. */
#include "lab/explore/delays.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "lab/explore/words_of.h"
#include "files/words.h"

void delays_free(struct delays *d)
{
    free(d->list);
    *d = (struct delays){0};
}

void delays_append(struct delays *d, struct delay one)
{
    d->list = xgrown(d->list, d->count, sizeof *d->list);
    d->list[d->count++] = one;
}

struct delays delays_copy(const struct delays *d)
{
    struct delays copy = {0};
    for (size_t i = 0; i < d->count; i++)
        delays_append(&copy, d->list[i]);
    return copy;
}

struct delays delays_subset(const struct delays *d, const unsigned char *keep)
{
    struct delays part = {0};
    for (size_t i = 0; i < d->count; i++)
        if (keep[i])
            delays_append(&part, d->list[i]);
    return part;
}

static struct delay *find(const struct delays *d, enum delay_kind kind, uint32_t node, uint64_t index)
{
    for (size_t i = 0; i < d->count; i++)
        if (d->list[i].kind == kind && d->list[i].node == node && d->list[i].index == index)
            return &d->list[i];
    return NULL;
}

void delays_add(struct delays *d, enum delay_kind kind, uint32_t node, uint64_t index, int64_t more)
{
    struct delay *there = find(d, kind, node, index);
    if (there)
        there->value += more;
    else
        delays_append(d, (struct delay){kind, node, index, more});
}

int64_t delays_value(const struct delays *d, enum delay_kind kind, uint32_t node, uint64_t index)
{
    const struct delay *there = find(d, kind, node, index);
    return there ? there->value : 0;
}

const char *delay_kind_name(enum delay_kind kind)
{
    static const char *const names[DELAY_KINDS] = {"speed", "start", "message", "interrupt"};
    return names[kind];
}

int delay_kind_is_indexed(enum delay_kind kind)
{
    return kind == DELAY_MESSAGE || kind == DELAY_INTERRUPT;
}

static void append_item(char **text, const struct delay *d, uint32_t nodes)
{
    words_append(text, "%s ", delay_kind_name(d->kind));
    if (d->node == nodes)
        words_append(text, "host");
    else
        words_append(text, "%" PRIu32, d->node);
    if (delay_kind_is_indexed(d->kind))
        words_append(text, " %" PRIu64, d->index);
    words_append(text, " %" PRId64 "\n", d->value);
}

char *delays_text(const struct delays *d, uint32_t nodes, const char *comment)
{
    char *text = xasprintf("touchstone-schedule 1\n%snodes %" PRIu32 "\n", comment, nodes);
    for (size_t i = 0; i < d->count; i++)
        append_item(&text, &d->list[i], nodes);
    return text;
}

char *delay_words(const struct delay *d, uint32_t nodes)
{
    char name[REC_NAME], time[REC_TIME], count[REC_ORDINAL];
    rec_node_name(d->node, nodes, name);
    rec_duration(d->value, time);
    rec_ordinal(d->index, count);
    switch (d->kind) {
    case DELAY_SPEED:
        return xasprintf("%s computes %.4g %% slower", name, (double)d->value / 1e4);
    case DELAY_START:
        return xasprintf("the program of %s begins %s later", name, time);
    case DELAY_MESSAGE:
        return xasprintf("the %s message that %s sends leaves %s later", count, name, time);
    default:
        return xasprintf("the %s handler of %s becomes due %s later", count, name, time);
    }
}
