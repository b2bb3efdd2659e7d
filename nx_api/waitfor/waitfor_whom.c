/* waitfor_whom.c - the nodes that could end a node's wait: the edges of the wait-for graph. */
#include "nx_api/waitfor/waitfor_parts.h"

bool waitfor_is_missed(const struct waitfor *w, uint32_t i, const void *operation)
{
    const struct waitfor_node *n = &w->nodes[i];
    return !n->is_host && !(n->state == WAITFOR_WAITS && n->operation == operation);
}

static void set_one(const struct waitfor *w, struct waitfor_node *n, long whom)
{
    if (whom < 0 || whom >= (long)w->count)
        return;
    n->who = WAITFOR_ONE_NODE;
    n->whom = (uint32_t)whom;
}

/* Any of those that live; the only one if there are no more. */
static void set_any(const struct waitfor *w, uint32_t living, struct waitfor_node *n)
{
    if (living > 2)
        n->who = WAITFOR_ANY_NODE;
    for (uint32_t i = 0; living == 2 && i < w->count; i++)
        if (waitfor_lives(&w->nodes[i]) && &w->nodes[i] != n)
            set_one(w, n, i);
}

/* For the ends of all others: the first that lives is one that it waits for. */
static void set_first_other(const struct waitfor *w, struct waitfor_node *n)
{
    for (uint32_t i = 0; i < w->count; i++)
        if (waitfor_lives(&w->nodes[i]) && &w->nodes[i] != n) {
            set_one(w, n, i);
            return;
        }
}

static void set(const struct waitfor *w, uint32_t living, struct waitfor_node *n)
{
    if (n->operation)
        n->who = WAITFOR_ALL_NODES;
    else if (n->is_locked)
        set_one(w, n, n->holder);
    else if (n->what == WAITFOR_MESSAGE && n->select.node != WAITFOR_ANY)
        set_one(w, n, n->select.node);
    else if (n->what == WAITFOR_BUFFER || (n->what == WAITFOR_END && n->to != WAITFOR_ANY))
        set_one(w, n, n->to);
    else if (n->what == WAITFOR_END && n->of_all)
        set_first_other(w, n);
    else if (n->what != WAITFOR_OTHER)
        set_any(w, living, n);
}

bool waitfor_lacks_host(const struct waitfor *w, const struct waitfor_node *n)
{
    return n->what == WAITFOR_MESSAGE && n->select.node >= (long)w->count;
}

void waitfor_find_whom(struct waitfor *w)
{
    uint32_t living = 0;
    for (uint32_t i = 0; i < w->count; i++) {
        struct waitfor_node *n = &w->nodes[i];
        living += waitfor_lives(n);
        n->who = WAITFOR_NOBODY;
        n->operation = n->state == WAITFOR_WAITS && n->what == WAITFOR_MESSAGE
                           ? waitfor_operation(n->select.typesel)
                           : NULL;
    }
    for (uint32_t i = 0; i < w->count; i++)
        if (w->nodes[i].state == WAITFOR_WAITS)
            set(w, living, &w->nodes[i]);
}

bool waitfor_needs(const struct waitfor *w, uint32_t a, uint32_t b)
{
    const struct waitfor_node *n = &w->nodes[a];
    switch (n->who) {
    case WAITFOR_ONE_NODE:
        return n->whom == b;
    case WAITFOR_ANY_NODE:
        return a != b && waitfor_lives(&w->nodes[b]);
    case WAITFOR_ALL_NODES:
        return waitfor_is_missed(w, b, n->operation);
    default:
        return false;
    }
}
