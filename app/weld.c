/* weld.c - a hash table of vertices by position; see weld.h. */
#include <stdlib.h>
#include <string.h>
#include "weld.h"

struct slot {
    float place[3];
    int number; /* -1: free */
};

struct weld {
    struct slot *slot; /* NULL: no memory; vertices are not joined */
    long slots, next;
};

struct weld *weld_begin(long corners)
{
    struct weld *w = malloc(sizeof *w);
    long i;

    if (!w)
        return NULL;
    w->next = 0;
    w->slots = corners + 1;
    w->slot = malloc(w->slots * sizeof *w->slot);
    for (i = 0; w->slot && i < w->slots; i++)
        w->slot[i].number = -1;
    return w;
}

static unsigned long hash(const float place[3])
{
    unsigned bits[3];

    memcpy(bits, place, sizeof bits);
    return (bits[0] * 73856093ul) ^ (bits[1] * 19349663ul) ^ (bits[2] * 83492791ul);
}

long weld_number(struct weld *w, const weld_vertex v)
{
    float place[3] = {v[0] + 0.0f, v[1] + 0.0f, v[2] + 0.0f}; /* -0 becomes 0 */
    struct slot *s;
    long i;

    if (!w->slot)
        return w->next++;
    for (i = (long)(hash(place) % (unsigned long)w->slots);; i = i + 1 < w->slots ? i + 1 : 0) {
        s = &w->slot[i];
        if (s->number < 0) {
            memcpy(s->place, place, sizeof place);
            s->number = (int)w->next++;
        }
        if (memcmp(s->place, place, sizeof place) == 0)
            return s->number;
    }
}

long weld_vertices(const struct weld *w)
{
    return w->next;
}

void weld_restart(struct weld *w)
{
    if (!w->slot)
        w->next = 0;
}

void weld_end(struct weld *w)
{
    free(w->slot);
    free(w);
}
