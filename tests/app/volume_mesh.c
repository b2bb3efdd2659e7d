/* volume_mesh.c - see volume_mesh.h. */
#include <stdlib.h>
#include <string.h>
#include "c3.h"
#include "layer.h"
#include "volume_mesh.h"

struct options options_of(const char *line)
{
    static char words[512]; /* options keep pointers to it */
    char error[256], *argv[64] = {"model"};
    struct options o;
    int argc = 1;
    strncpy(words, line, sizeof words - 1);
    words[sizeof words - 1] = 0;
    for (char *w = strtok(words, " "); w; w = strtok(NULL, " "))
        argv[argc++] = w;
    if (options_read(&o, argc, argv, error, sizeof error))
        abort();
    return o;
}

static size_t slice_pixels(const struct grid *g)
{
    return (size_t)g->pixels_x * (size_t)g->pixels_y;
}

pixel *volume_sphere(const struct grid *g)
{
    pixel *p = malloc((size_t)g->slices * slice_pixels(g) * sizeof *p);
    for (int k = 0; k < g->slices; k++)
        slice_sphere(g, k, p + (size_t)k * slice_pixels(g));
    return p;
}

pixel *volume_noise(const struct grid *g, unsigned seed, int levels)
{
    size_t n = (size_t)g->slices * slice_pixels(g);
    pixel *p = malloc(n * sizeof *p);
    for (size_t i = 0; i < n; i++)
        p[i] = (pixel)(rand_r(&seed) % levels);
    return p;
}

double *volume_data(const struct grid *g, const pixel *pixels)
{
    size_t doubles = (size_t)grid_slice_doubles(g), n = slice_pixels(g);
    double *data = malloc((size_t)g->slices * doubles * sizeof *data);
    for (int k = 0; k < g->slices; k++) {
        const pixel *image = pixels + (size_t)k * n;
        double *to = data + (size_t)k * doubles;
        if (g->comps == 1)
            c0_slice(g, image, to);
        else
            c3_slice(g, k > 0 ? image - n : NULL, image, k < g->slices - 1 ? image + n : NULL, to);
    }
    return data;
}

void volume_polygons(const struct options *o, const pixel *pixels, polygon_fn *out)
{
    const struct grid *g = &o->grid;
    double *data = volume_data(g, pixels);
    struct fit_system system = {0};
    layer_prepare(o, &system, 0);
    for (int k = 0; k < g->slices - 1; k++) {
        const double *lower = data + (size_t)k * (size_t)grid_slice_doubles(g);
        struct layer l = {.lower = lower, .upper = lower + grid_slice_doubles(g), .number = k, .row = 0};
        for (int i = 0; i < grid_cells(g); i++)
            layer_cell(o, &system, &l, i, out);
    }
    free(data);
}

/* --- the mesh of one surface --- */

struct place {
    double x, y, z;
};

struct edge {
    struct place from, to; /* from < to */
    int direction;         /* +1 as walked, -1 the other way */
};

static struct {
    int iso;
    struct edge *edge;
    size_t edges, room, polygons;
} found;

/* -0 becomes 0: places are compared bit by bit. */
static struct place place_of(const vertex v)
{
    return (struct place){v[0] + 0.0, v[1] + 0.0, v[2] + 0.0};
}

static void keep_edges(int iso, int n, const vertex *v)
{
    if (iso != found.iso)
        return;
    found.polygons++;
    for (int i = 0; i < n; i++) {
        struct place a = place_of(v[i]), b = place_of(v[(i + 1) % n]);
        int order = memcmp(&a, &b, sizeof a);
        if (found.edges == found.room) {
            found.room = 2 * found.room + 1000;
            found.edge = realloc(found.edge, found.room * sizeof *found.edge);
        }
        if (order != 0)
            found.edge[found.edges++] = order < 0 ? (struct edge){a, b, 1} : (struct edge){b, a, -1};
    }
}

static int compare_edges(const void *a, const void *b)
{
    return memcmp(a, b, 2 * sizeof(struct place));
}

static int compare_places(const void *a, const void *b)
{
    return memcmp(a, b, sizeof(struct place));
}

static size_t count_vertices(void)
{
    struct place *p = malloc((2 * found.edges + 1) * sizeof *p);
    size_t n = 0;
    for (size_t i = 0; i < found.edges; i++) {
        p[2 * i] = found.edge[i].from;
        p[2 * i + 1] = found.edge[i].to;
    }
    qsort(p, 2 * found.edges, sizeof *p, compare_places);
    for (size_t i = 0; i < 2 * found.edges; i++)
        n += i == 0 || memcmp(&p[i], &p[i - 1], sizeof *p) != 0;
    free(p);
    return n;
}

static bool both(double a, double b, double at)
{
    return a == at && b == at;
}

/* Does the edge lie in the volume's border? */
static bool on_border(const struct grid *g, const struct edge *e)
{
    const struct place *a = &e->from, *b = &e->to;
    return both(a->x, b->x, 0) || both(a->x, b->x, g->pixels_x - 1) || both(a->y, b->y, 0) ||
           both(a->y, b->y, g->pixels_y - 1) || both(a->z, b->z, 0) ||
           both(a->z, b->z, (g->slices - 1) * g->dz);
}

struct mesh_edges volume_mesh(const struct options *o, const pixel *pixels, int iso)
{
    struct mesh_edges m = {0};
    memset(&found, 0, sizeof found);
    found.iso = iso;
    volume_polygons(o, pixels, keep_edges);
    if (found.edges == 0)
        return m;
    m.polygons = found.polygons;
    qsort(found.edge, found.edges, sizeof *found.edge, compare_edges);
    m.vertices = count_vertices();
    for (size_t i = 0, j; i < found.edges; i = j) {
        int sum = 0;
        for (j = i; j < found.edges && compare_edges(&found.edge[i], &found.edge[j]) == 0; j++)
            sum += found.edge[j].direction;
        m.edges++;
        if (sum != 0 && on_border(&o->grid, &found.edge[i]))
            m.borders++;
        else if (sum != 0 || j - i != 2)
            m.open++;
    }
    free(found.edge);
    return m;
}
