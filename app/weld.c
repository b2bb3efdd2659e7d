/* weld.c - a hash table of vertices by position; see weld.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "fail.h"
#include "weld.h"

#define LEAST 64                    /* vertices */
#define RESERVE (64 << 10)          /* bytes left for buffers of files */
#define NORMAL_UNIT 1099511627776.0 /* 2^40: a component of a unit normal as a whole number */

struct entry {
    float place[3];
    int number;
    long long normal[3]; /* sum over the corners here */
};

/* slot[] has numbers of entries, or -1, at their hash values or behind them. */
struct weld {
    struct entry *entry;
    int *slot;
    long room, used, kept, next;
};

/* Two slots an entry, so that searches are short. */
static long slots(const struct weld *w)
{
    return 2 * w->room;
}

static void clear_slots(struct weld *w)
{
    long i;

    for (i = 0; i < slots(w); i++)
        w->slot[i] = -1;
}

struct weld *weld_begin(long most)
{
    struct weld *w = allocate(sizeof *w);
    void *reserve = allocate_if_room(RESERVE);

    memset(w, 0, sizeof *w);
    for (w->room = most > LEAST ? most : LEAST; reserve && w->room >= LEAST; w->room -= w->room / 8) {
        w->entry = allocate_if_room(w->room * sizeof *w->entry);
        w->slot = w->entry ? allocate_if_room(slots(w) * sizeof *w->slot) : NULL;
        if (w->slot)
            break;
        free(w->entry);
        w->entry = NULL;
    }
    if (!w->slot)
        w->room = 0;
    free(reserve);
    clear_slots(w);
    return w;
}

long weld_room(const struct weld *w)
{
    return w->room;
}

static void place_of(float place[3], const part_vertex v)
{
    int d;

    for (d = 0; d < 3; d++)
        place[d] = v[d] + 0.0f; /* -0 becomes 0 */
}

static unsigned hash(const float place[3])
{
    unsigned bits[3];

    memcpy(bits, place, sizeof bits);
    return (bits[0] * 73856093u) ^ (bits[1] * 19349663u) ^ (bits[2] * 83492791u);
}

/* The slot at a hash value, of which the high bits depend on all bits of the place. A node of 1992 multiplies
 * in a few clocks, and divides in dozens. */
static long home(const struct weld *w, const float place[3])
{
    return (long)((unsigned long long)hash(place) * (unsigned long long)slots(w) >> 32);
}

/* The slot of the vertex at a place, or the free slot where it would be. */
static int *find(const struct weld *w, const float place[3])
{
    long i = home(w, place);

    while (w->slot[i] >= 0 && memcmp(w->entry[w->slot[i]].place, place, sizeof w->entry->place))
        i = i + 1 < slots(w) ? i + 1 : 0;
    return &w->slot[i];
}

void weld_forget(struct weld *w, float z)
{
    long i;

    clear_slots(w);
    for (w->kept = i = 0; i < w->used; i++)
        if (w->entry[i].place[2] == z) {
            *find(w, w->entry[i].place) = (int)w->kept;
            w->entry[w->kept++] = w->entry[i];
        }
    w->used = w->kept;
}

static void add_normal(struct entry *e, const part_vertex v)
{
    int d;

    for (d = 0; d < 3; d++)
        e->normal[d] += (long long)(v[3 + d] * NORMAL_UNIT);
}

long weld_add(struct weld *w, const part_vertex v)
{
    float place[3];
    struct entry *e;
    int *s;

    if (w->room == 0)
        return -1;
    place_of(place, v);
    s = find(w, place);
    if (*s < 0 && w->used == w->room)
        return -1;
    if (*s < 0) {
        *s = (int)w->used++;
        e = &w->entry[*s];
        memset(e, 0, sizeof *e);
        memcpy(e->place, place, sizeof place);
        e->number = (int)w->next++;
    }
    e = &w->entry[*s];
    add_normal(e, v);
    return e->number;
}

static struct entry *entry_at(const struct weld *w, const part_vertex v)
{
    float place[3];
    int s;

    if (w->room == 0)
        return NULL;
    place_of(place, v);
    s = *find(w, place);
    return s < 0 ? NULL : &w->entry[s];
}

long weld_find(const struct weld *w, const part_vertex v)
{
    const struct entry *e = entry_at(w, v);

    return e ? e->number : -1;
}

void weld_normal(struct weld *w, const part_vertex v)
{
    struct entry *e = entry_at(w, v);

    if (e)
        add_normal(e, v);
}

long weld_next(const struct weld *w)
{
    return w->next;
}

void weld_skip(struct weld *w, long n)
{
    w->next += n;
}

int weld_vertex(const struct weld *w, long nth, part_vertex v)
{
    const struct entry *e = &w->entry[w->kept + nth];
    double normal[3];
    int d;

    if (w->kept + nth >= w->used)
        return 0;
    for (d = 0; d < 3; d++)
        normal[d] = (double)e->normal[d];
    polygon_normalise(normal);
    for (d = 0; d < 3; d++) {
        v[d] = e->place[d];
        v[3 + d] = (float)normal[d];
    }
    return 1;
}

void weld_end(struct weld *w)
{
    free(w->entry);
    free(w->slot);
    free(w);
}
