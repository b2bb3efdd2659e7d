/* ply.c - joins the part files of a surface to a PLY file, its vertices welded; see ply.h.
 *
 * The polygons are sorted by layer first. A table then holds the vertices of the layer at hand and those on
 * its lower side, which have their numbers from the layer below. The polygons of a layer are read
 *  - to number its new vertices, and add up their normals;
 *  - with the layer below, to add up the normals of the vertices that both share;
 *  - to write its faces.
 *
 * If there is no memory for all vertices of a layer, corners are left whose vertices are not in the table:
 * each becomes a vertex of its own, numbered after the layer's others. Vertices and faces have two places in
 * the file and are written in turn: all layers are gone through once before, to count the vertices.
 */
#include <nx.h>
#include "fail.h"
#include "layer_file.h"
#include "ply.h"
#include "weld.h"

struct join {
    struct layer_file *in;
    struct weld *weld;
    FILE *out;
    int by_node;
    long vertex_at, face_at; /* in the file: where to write on */
};

/* Numbers the vertices of a layer. Answers the loose corners. */
static long number_layer(struct join *j, int layer)
{
    struct part_polygon p;
    long loose = 0;
    int i;

    weld_forget(j->weld, layer_floor(j->in->grid, layer));
    layer_file_open(j->in, layer);
    while (layer_file_next(j->in, &p))
        for (i = 0; i < p.n; i++)
            loose += weld_add(j->weld, p.v[i]) < 0;
    return loose;
}

/* A layer shares only vertices on its lower side with the layer below. */
static void add_shared_normals(struct join *j, int layer)
{
    struct part_polygon p;
    float floor = layer_floor(j->in->grid, layer);
    int i;

    layer_file_open(j->in, layer);
    while (layer_file_next(j->in, &p))
        for (i = 0; i < p.n; i++)
            if (p.v[i][2] == floor)
                weld_normal(j->weld, p.v[i]);
}

static void write_vertices(struct join *j, int layer, long loose)
{
    struct part_polygon p;
    part_vertex v;
    long nth;
    int i;

    fseek(j->out, j->vertex_at, SEEK_SET);
    for (nth = 0; weld_vertex(j->weld, nth, v); nth++)
        fwrite(v, sizeof v, 1, j->out);
    layer_file_open(j->in, layer);
    while (loose > 0 && layer_file_next(j->in, &p))
        for (i = 0; i < p.n; i++)
            if (weld_find(j->weld, p.v[i]) < 0)
                fwrite(p.v[i], sizeof p.v[i], 1, j->out);
    j->vertex_at = ftell(j->out);
}

/* first_loose: the number of the layer's first loose corner. */
static void write_faces(struct join *j, int layer, long first_loose)
{
    struct part_polygon p;
    int i, number;

    fseek(j->out, j->face_at, SEEK_SET);
    layer_file_open(j->in, layer);
    while (layer_file_next(j->in, &p)) {
        fputc(p.n, j->out);
        for (i = 0; i < p.n; i++) {
            number = (int)weld_find(j->weld, p.v[i]);
            if (number < 0)
                number = (int)first_loose++;
            fwrite(&number, sizeof number, 1, j->out);
        }
        if (j->by_node)
            fwrite(&p.node, sizeof p.node, 1, j->out);
    }
    j->face_at = ftell(j->out);
}

/* The table has the vertices of one layer, and of the layer below those that both share. */
static long vertices_at_a_time(const struct layer_file *in)
{
    long most = 0, now;
    int layer;

    for (layer = 0; layer < in->grid->slices - 1; layer++) {
        now = in->corners[layer] + (layer > 0 ? in->corners[layer - 1] : 0);
        if (now > most)
            most = now;
    }
    return most;
}

/* Goes through all layers, and writes them if there is a file for it. */
static void go_through(struct join *j, struct ply_file *f)
{
    int layer, layers = j->in->grid->slices - 1;
    long loose, first_loose;

    j->weld = weld_begin(vertices_at_a_time(j->in));
    for (f->loose = 0, layer = 0; layer < layers; layer++) {
        loose = number_layer(j, layer);
        first_loose = weld_next(j->weld);
        if (j->out) {
            if (layer + 1 < layers)
                add_shared_normals(j, layer + 1);
            write_vertices(j, layer, loose);
            write_faces(j, layer, first_loose);
        }
        weld_skip(j->weld, loose);
        f->loose += loose;
    }
    f->vertices = weld_next(j->weld);
    f->room = weld_room(j->weld);
    weld_end(j->weld);
}

static void write_header(struct join *j, const struct ply_file *f, double isovalue)
{
    fprintf(j->out, "ply\nformat binary_little_endian 1.0\ncomment isovalue %.10g\n", isovalue);
    fprintf(j->out, "element vertex %ld\n", f->vertices);
    fprintf(j->out, "property float x\nproperty float y\nproperty float z\n");
    fprintf(j->out, "property float nx\nproperty float ny\nproperty float nz\n");
    fprintf(j->out, "element face %ld\nproperty list uchar int vertex_indices\n", f->polygons);
    if (j->by_node)
        fprintf(j->out, "property int node\n");
    fprintf(j->out, "end_header\n");
    j->vertex_at = ftell(j->out);
    j->face_at = j->vertex_at + f->vertices * (long)sizeof(part_vertex);
}

static void write_file(struct join *j, struct ply_file *f, double isovalue)
{
    char unfinished[sizeof f->name + 8];
    int bad;

    snprintf(unfinished, sizeof unfinished, "%s.part", f->name);
    j->out = fopen(unfinished, "wb");
    if (!j->out)
        fail("cannot write %s", unfinished);
    write_header(j, f, isovalue);
    go_through(j, f);
    bad = ferror(j->out);
    if (fclose(j->out) || bad || rename(unfinished, f->name))
        fail("cannot write %s: is the disk full?", f->name);
}

struct ply_file ply_join(const struct options *o, int surface, int nodes, int step)
{
    struct part_reader parts = {.prefix = o->ply, .surface = surface, .nodes = nodes, .step = step};
    struct join j = {.by_node = o->each & EACH_MARKED};
    struct ply_file f;

    snprintf(f.name, sizeof f.name, "%s_%d.ply", o->ply, surface);
    j.in = layer_file_begin(&o->grid, &parts);
    f.polygons = j.in->polygons;
    go_through(&j, &f);
    write_file(&j, &f, o->asked[surface]);
    layer_file_end(j.in);
    part_remove(&parts);
    return f;
}
