/* observer.c - see observer.h. */
#include "os/observer.h"
#include <assert.h>
#include <string.h>

/* What is wanted: the bits of the functions that are there. */
static uint64_t wants(const struct announcements *hears)
{
    typedef void function(void);
    _Static_assert(sizeof *hears / sizeof(function *) <= 64, "node.heard has too few bits");
    uint64_t bits = 0;
    for (size_t i = 1; i < sizeof *hears / sizeof(function *); i++) { /* the first is in_order */
        function *f;
        memcpy(&f, (const char *)hears + i * sizeof f, sizeof f);
        bits |= (uint64_t)(f != NULL) << i;
    }
    return bits;
}

static void note_heard(struct node *n)
{
    n->heard = 0;
    for (const struct observer *o = n->observers; o; o = o->next)
        n->heard |= wants(o->hears);
}

void observer_add(struct node *n, struct observer *o)
{
    struct observer **end = &n->observers;
    while (*end)
        end = &(*end)->next;
    o->next = NULL;
    n->deferred.never |= o->hears->in_order;
    *end = o;
    note_heard(n);
}

void observer_wants(struct node *n, struct observer *o, const struct announcements *hears)
{
    o->hears = hears;
    note_heard(n);
}

void observer_remove(struct node *n, struct observer *o)
{
    struct observer **link = &n->observers;
    for (; *link != o; link = &(*link)->next)
        assert(*link);
    *link = o->next;
    note_heard(n);
}
