/* waits.c - see waits.h. */
#include "node/waits.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

/* A program whose types are ever new ones would have an entry for each. */
enum { MOST_TYPES = 256 };

/* Most names of one call are one text, so comparing addresses settles most cases. */
static bool is_call(const char *a, const char *b)
{
    return a == b || strcmp(a, b) == 0;
}

static struct node_wait *entry(struct node_waits *w, const char *call, bool has_type, long type)
{
    for (size_t i = 0; i < w->count; i++) {
        struct node_wait *e = &w->list[i];
        if (e->type == type && e->has_type == has_type && is_call(e->call, call))
            return e;
    }
    if (has_type && w->count >= MOST_TYPES)
        return entry(w, call, false, 0);
    if (w->count == w->room) {
        w->room = w->room ? 2 * w->room : 1; /* most programs wait in few calls */
        w->list = xreallocarray(w->list, w->room, sizeof *w->list);
    }
    w->list[w->count] = (struct node_wait){.call = call, .has_type = has_type, .type = type};
    return &w->list[w->count++];
}

void waits_add(struct node_waits *w, const char *call, bool has_type, long type, vtime idle)
{
    struct node_wait *e = entry(w, call, has_type, has_type ? type : 0);
    e->idle += idle;
    e->waits++;
}

void waits_free(struct node_waits *w)
{
    free(w->list);
    *w = (struct node_waits){0};
}
