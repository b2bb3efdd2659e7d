/* layer_file.c - sorts polygons by layer, in two passes: the layers' sizes, then each polygon to its place.
 * Within a layer they come from nodes in any order; they are sorted by their vertices then. */
#include <stdlib.h>
#include <string.h>
#include "fail.h"
#include "layer_file.h"

#define PIECES_MAX (POLYGON_MAX / 3)

float layer_floor(const struct grid *g, int layer)
{
    return (float)(layer * g->dz);
}

/* The layer of a polygon. If all its vertices lie between two layers, one of the two. */
static int layer_of(const struct grid *g, const struct part_polygon *p)
{
    float low = p->v[0][2];
    int i, layer;

    for (i = 1; i < p->n; i++)
        if (p->v[i][2] < low)
            low = p->v[i][2];
    layer = (int)(low / g->dz);
    while (layer > 0 && layer_floor(g, layer) > low)
        layer--;
    while (layer < g->slices - 2 && layer_floor(g, layer + 1) <= low)
        layer++;
    return layer;
}

static int equal(const part_vertex a, const part_vertex b)
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* Vertices first to last - 1 of p, which is a ring. */
static struct part_polygon arc(const struct part_polygon *p, int first, int last)
{
    struct part_polygon a;

    a.node = p->node;
    for (a.n = 0; first < last; first++)
        memcpy(a.v[a.n++], p->v[first % p->n], sizeof a.v[0]);
    return a;
}

/* Cuts a polygon where two of its vertices are at one place. Answers the number of pieces. */
static int cut(const struct part_polygon *p, struct part_polygon *piece)
{
    struct part_polygon a, b;
    int i, j, n;

    for (i = 0; i < p->n; i++)
        for (j = i + 1; j < p->n; j++)
            if (equal(p->v[i], p->v[j])) {
                a = arc(p, i, j);
                b = arc(p, j, i + p->n);
                n = cut(&a, piece);
                return n + cut(&b, piece + n);
            }
    if (p->n < 3)
        return 0;
    *piece = *p;
    return 1;
}

static int layers(const struct layer_file *f)
{
    return f->grid->slices - 1;
}

/* For each layer its corners, and where it begins in the file. */
static void measure(struct layer_file *f, struct part_reader r)
{
    struct part_polygon p, piece[PIECES_MAX];
    int n, layer;

    while (part_next(&r, &p))
        for (n = cut(&p, piece); n-- > 0; f->polygons++) {
            layer = layer_of(f->grid, &piece[n]);
            f->corners[layer] += piece[n].n;
            f->begin[layer + 1] += part_polygon_bytes(&piece[n]);
        }
    for (layer = 0; layer < layers(f); layer++)
        f->begin[layer + 1] += f->begin[layer];
}

/* Writes each polygon where its layer goes on: next[layer]. Polygons of one layer mostly follow each
 * other. */
static void distribute(struct layer_file *f, struct part_reader r, long *next)
{
    struct part_polygon p, piece[PIECES_MAX];
    int n, layer, last = -1;

    while (part_next(&r, &p))
        for (n = cut(&p, piece); n-- > 0; last = layer) {
            layer = layer_of(f->grid, &piece[n]);
            if (layer != last)
                fseek(f->file, next[layer], SEEK_SET);
            part_write_polygon(f->file, &piece[n]);
            next[layer] += part_polygon_bytes(&piece[n]);
        }
}

/* Compares polygons in memory, each a float and its vertices, by their vertices. */
static int compare(const void *a, const void *b)
{
    const float *p = *(const float *const *)a, *q = *(const float *const *)b;
    int n = (int)*p % PART_NODE, m = (int)*q % PART_NODE, i;

    for (i = 1; i <= 6 * (n < m ? n : m); i++)
        if (p[i] != q[i])
            return p[i] < q[i] ? -1 : 1;
    return n - m;
}

static void write_sorted(struct layer_file *f, int layer, const float *floats, const float **polygon)
{
    long bytes = f->begin[layer + 1] - f->begin[layer], n = 0, i;
    const float *end = floats + bytes / (long)sizeof *floats, *p;

    for (p = floats; p < end; p += 1 + 6 * ((int)*p % PART_NODE))
        polygon[n++] = p;
    qsort(polygon, n, sizeof *polygon, compare);
    fseek(f->file, f->begin[layer], SEEK_SET);
    for (i = 0; i < n; i++)
        fwrite(polygon[i], sizeof **polygon, 1 + 6 * ((int)*polygon[i] % PART_NODE), f->file);
}

/* If there is no memory for a layer, its order stays, which depends on the nodes. */
static void sort_layer(struct layer_file *f, int layer)
{
    long bytes = f->begin[layer + 1] - f->begin[layer], most = f->corners[layer] / 3;
    float *floats = allocate_if_room(bytes + 1);
    const float **polygon = allocate_if_room((most + 1) * sizeof *polygon);

    if (floats && polygon) {
        fseek(f->file, f->begin[layer], SEEK_SET);
        if ((long)fread(floats, 1, bytes, f->file) != bytes)
            fail("cannot read %s", f->name);
        write_sorted(f, layer, floats, polygon);
    }
    free(floats);
    free(polygon);
}

static long *longs(int n)
{
    long *p = allocate(n * sizeof *p);

    memset(p, 0, n * sizeof *p);
    return p;
}

struct layer_file *layer_file_begin(const struct grid *g, const struct part_reader *r)
{
    struct layer_file *f = allocate(sizeof *f);
    long *next = longs(g->slices);
    int layer;

    memset(f, 0, sizeof *f);
    f->grid = g;
    f->corners = longs(g->slices);
    f->begin = longs(g->slices);
    measure(f, *r);
    snprintf(f->name, sizeof f->name, "%s_%d.layers", r->prefix, r->surface);
    f->file = fopen(f->name, "w+b");
    if (!f->file)
        fail("cannot write %s", f->name);
    memcpy(next, f->begin, g->slices * sizeof *next);
    distribute(f, *r, next);
    free(next);
    for (layer = 0; layer < layers(f); layer++)
        sort_layer(f, layer);
    if (fflush(f->file) || ferror(f->file))
        fail("cannot write %s: is the disk full?", f->name);
    return f;
}

void layer_file_open(struct layer_file *f, int layer)
{
    f->left = f->begin[layer + 1] - f->begin[layer];
    fseek(f->file, f->begin[layer], SEEK_SET);
}

int layer_file_next(struct layer_file *f, struct part_polygon *p)
{
    if (f->left <= 0)
        return 0;
    if (!part_read(f->file, p))
        fail("cannot read %s", f->name);
    f->left -= part_polygon_bytes(p);
    return 1;
}

void layer_file_end(struct layer_file *f)
{
    fclose(f->file);
    remove(f->name);
    free(f->corners);
    free(f->begin);
    free(f);
}
