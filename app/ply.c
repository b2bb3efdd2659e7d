/* ply.c - part files of polygons, and the PLY files made of them; see ply.h. */
#include <stdlib.h>
#include <nx.h>
#include "fail.h"
#include "ply.h"
#include "weld.h"

#define NAME_SIZE 512
#define POLYGON_SIZE 16

static void part_name(char *name, const char *prefix, int surface, int node)
{
    snprintf(name, NAME_SIZE, "%s_%d.node%d.part", prefix, surface, node);
}

FILE *ply_part_begin(const char *prefix, int surface, int node)
{
    char name[NAME_SIZE];
    FILE *part;
    long old = masktrap(1);

    part_name(name, prefix, surface, node);
    part = fopen(name, "wb");
    masktrap(old);
    if (!part)
        fail("cannot write %s", name);
    return part;
}

/* A part file holds floats: n, then n vertices of x y z and normal. */
void ply_part_write(FILE *part, const double *polygons, int doubles)
{
    static float single[1024];
    int i, n;

    for (; doubles > 0; doubles -= n, polygons += n) {
        n = doubles < 1024 ? doubles : 1024;
        for (i = 0; i < n; i++)
            single[i] = (float)polygons[i];
        if ((int)fwrite(single, sizeof *single, n, part) != n)
            fail("cannot write a part file: is the disk full?");
    }
}

void ply_part_end(FILE *part)
{
    if (fclose(part))
        fail("cannot write a part file: is the disk full?");
}

/* --- joining the parts --- */

/* Reads the polygons of one surface, part after part. */
struct reader {
    const char *prefix;
    int surface, nodes, step, node;
    FILE *part;
};

static int next_polygon(struct reader *r, int *n, weld_vertex *v)
{
    char name[NAME_SIZE];
    float count;

    for (;;) {
        if (r->part && fread(&count, sizeof count, 1, r->part) == 1) {
            *n = (int)count;
            if (*n > POLYGON_SIZE || (int)fread(v, sizeof *v, *n, r->part) != *n)
                fail("a part file of %s is damaged", r->prefix);
            return 1;
        }
        if (r->part) {
            fclose(r->part);
            r->node += r->step;
        }
        r->part = NULL;
        if (r->node >= r->nodes)
            return 0;
        part_name(name, r->prefix, r->surface, r->node);
        r->part = fopen(name, "rb");
        if (!r->part)
            fail("cannot read %s", name);
    }
}

static void write_header(FILE *out, long vertices, long faces)
{
    fprintf(out, "ply\nformat binary_little_endian 1.0\nelement vertex %ld\n", vertices);
    fprintf(out, "property float x\nproperty float y\nproperty float z\n");
    fprintf(out, "property float nx\nproperty float ny\nproperty float nz\n");
    fprintf(out, "element face %ld\nproperty list uchar int vertex_indices\nend_header\n", faces);
}

/* Writes the vertices in the order of their numbers; a vertex is new if its number is the next to be
 * written. */
static void write_vertices(FILE *out, struct reader r, struct weld *w)
{
    weld_vertex v[POLYGON_SIZE];
    int n, i;
    long written = 0;

    weld_restart(w);
    while (next_polygon(&r, &n, v))
        for (i = 0; i < n; i++)
            if (weld_number(w, v[i]) == written) {
                fwrite(v[i], sizeof v[i], 1, out);
                written++;
            }
}

static void write_faces(FILE *out, struct reader r, struct weld *w)
{
    weld_vertex v[POLYGON_SIZE];
    int n, i, number;

    weld_restart(w);
    while (next_polygon(&r, &n, v)) {
        fputc(n, out);
        for (i = 0; i < n; i++) {
            number = (int)weld_number(w, v[i]);
            fwrite(&number, sizeof number, 1, out);
        }
    }
}

static void remove_parts(const struct reader *r)
{
    char name[NAME_SIZE];
    int node;

    for (node = 0; node < r->nodes; node += r->step) {
        part_name(name, r->prefix, r->surface, node);
        remove(name);
    }
}

void ply_join(const char *prefix, int surface, int nodes, int step)
{
    const struct reader start = {.prefix = prefix, .surface = surface, .nodes = nodes, .step = step};
    struct reader r = start;
    char name[NAME_SIZE], unfinished[NAME_SIZE + 8];
    weld_vertex v[POLYGON_SIZE];
    long corners = 0, faces = 0;
    struct weld *w;
    int n, i;
    FILE *out;

    for (; next_polygon(&r, &n, v); faces++)
        corners += n;
    w = weld_begin(corners);
    for (r = start; next_polygon(&r, &n, v);)
        for (i = 0; i < n; i++)
            weld_number(w, v[i]);
    snprintf(name, sizeof name, "%s_%d.ply", prefix, surface);
    snprintf(unfinished, sizeof unfinished, "%s.part", name);
    out = fopen(unfinished, "wb");
    if (!out)
        fail("cannot write %s", unfinished);
    write_header(out, weld_vertices(w), faces);
    write_vertices(out, start, w);
    write_faces(out, start, w);
    n = ferror(out);
    if (fclose(out) || n || rename(unfinished, name))
        fail("cannot write %s", name);
    remove_parts(&start);
    weld_end(w);
}
