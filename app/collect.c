/* collect.c - polygons on lists, one per isovalue; see collect.h. */
#include <stdio.h>
#include <string.h>
#include <nx.h>
#include "collect.h"
#include "fail.h"
#include "part_file.h"
#include "times.h"

#define LIST_DOUBLES 4096

/* Polygon after polygon, each its number of vertices and its vertices. A full list is written to the part
 * file, or dropped. */
struct list {
    double *data;
    int used;
    FILE *part;
};

static struct {
    const struct options *o;
    int node;
    struct collection found;
    struct list list[ISOVALUES_MAX];
} all;

const struct collection *collect_begin(const struct options *o, int node)
{
    int i;

    memset(&all, 0, sizeof all);
    all.o = o;
    all.node = node;
    for (i = 0; i < o->iso.n; i++) {
        all.list[i].data = allocate(LIST_DOUBLES * sizeof(double));
        if (o->ply)
            all.list[i].part = part_begin(o->ply, i, node);
    }
    return &all.found;
}

static void write_part(const struct list *l)
{
    double start = dclock();

    part_write(l->part, l->data, l->used);
    all.found.written_s += dclock() - start;
}

static void empty(struct list *l)
{
    if (l->part)
        write_part(l);
    l->used = 0;
}

/* A number that depends on each bit of a polygon's vertices (FNV-1a). */
static unsigned long long hash(int iso, int n, const vertex *v)
{
    unsigned long long h = 14695981039346656037ull + (unsigned)iso;
    const unsigned char *p = (const unsigned char *)v, *end = p + n * sizeof *v;

    for (; p < end; p++)
        h = (h ^ *p) * 1099511628211ull;
    return h;
}

/* The node that made the polygon at hand: a handler collects those of the node whose message it has just
 * received, the main program its own. */
static int maker(void)
{
    return (int)(times_now() == COLLECTING ? infonode() : mynode());
}

/* What is done with each polygon, which is the last on its list, besides counting. */
static void look_at(const struct list *l, int iso, int n, const vertex *v)
{
    if (all.o->each & EACH_HASHED)
        all.found.digest += hash(iso, n, v);
    if (all.o->each & EACH_MARKED)
        l->data[l->used - 1 - 6 * n] = n + PART_NODE * maker();
}

int collect_pack(int n, const vertex *v, double *to)
{
    const double *from = v[0];
    int i;

    *to++ = n;
    for (i = 0; i < 6 * n; i++)
        *to++ = *from++;
    return 1 + 6 * n;
}

void collect_polygon(int iso, int n, const vertex *v)
{
    struct list *l = &all.list[iso];

    if (l->used + 1 + 6 * n > LIST_DOUBLES)
        empty(l);
    l->used += collect_pack(n, v, l->data + l->used);
    all.found.polygons[iso] += 1;
    if (all.o->each)
        look_at(l, iso, n, v);
}

void collect_packed(int iso, const double *set, long doubles)
{
    const double *end = set + doubles;
    int n;

    for (; set < end; set += 1 + 6 * n) {
        n = (int)set[0];
        collect_polygon(iso, n, (const vertex *)(set + 1));
    }
}

void collect_end(void)
{
    int i;

    for (i = 0; i < all.o->iso.n; i++) {
        empty(&all.list[i]);
        if (all.list[i].part)
            part_end(all.list[i].part);
        all.list[i].part = NULL;
    }
}
