/* ply_facts.c - reads a PLY file as a viewer does, and prints what a test of a surface wants to know.
 *
 *     ply_facts FILE [box X Y Z] [centre X Y Z]
 *     ply_facts FILE list
 *
 * Prints one "key value" a line. Nothing of the program that wrote the file is used. An edge is open if it
 * is not walked equally often in both directions; with a box from 0 to X Y Z, edges in its sides are
 * borders instead. list prints a line for each face, its vertices from the smallest on: sorted, the lines
 * do not depend on the order of faces and vertices.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct vertex {
    float at[3], normal[3];
};

struct face {
    int n, *index, node;
};

/* A side of a face: from < to; direction is 1 as walked, -1 the other way. */
struct side {
    int from, to, direction;
};

static struct {
    long vertices, faces;
    struct vertex *vertex;
    struct face *face;
    int has_nodes;
} mesh;

static double box[3], centre[3];
static int has_box, has_centre;

static void fail(const char *what)
{
    fprintf(stderr, "ply_facts: %s\n", what);
    exit(1);
}

static void *allocate(size_t n, size_t size)
{
    void *p = calloc(n + 1, size);
    if (!p)
        fail("no memory");
    return p;
}

static void expect(FILE *in, const char *want)
{
    char line[256];
    if (!fgets(line, sizeof line, in) || strncmp(line, want, strlen(want)) != 0)
        fail(want);
}

/* A line "WORDS n", after comments. */
static long read_count(FILE *in, const char *words)
{
    char line[256];
    do
        if (!fgets(line, sizeof line, in))
            fail(words);
    while (!strncmp(line, "comment", 7));
    if (strncmp(line, words, strlen(words)) != 0)
        fail(words);
    return atol(line + strlen(words));
}

static void read_header(FILE *in)
{
    char line[256];
    expect(in, "ply\n");
    expect(in, "format binary_little_endian 1.0\n");
    mesh.vertices = read_count(in, "element vertex ");
    expect(in, "property float x\n");
    expect(in, "property float y\n");
    expect(in, "property float z\n");
    expect(in, "property float nx\n");
    expect(in, "property float ny\n");
    expect(in, "property float nz\n");
    mesh.faces = read_count(in, "element face ");
    expect(in, "property list uchar int vertex_indices\n");
    while (fgets(line, sizeof line, in) && strcmp(line, "end_header\n") != 0)
        if (strcmp(line, "property int node\n") == 0)
            mesh.has_nodes = 1;
        else
            fail("unknown line in the header");
}

static void read_numbers(void *to, size_t size, size_t n, FILE *in)
{
    if (fread(to, size, n, in) != n)
        fail("the file is too short");
}

static void read_mesh(FILE *in)
{
    read_header(in);
    mesh.vertex = allocate((size_t)mesh.vertices, sizeof *mesh.vertex);
    mesh.face = allocate((size_t)mesh.faces, sizeof *mesh.face);
    read_numbers(mesh.vertex, sizeof *mesh.vertex, (size_t)mesh.vertices, in);
    for (struct face *f = mesh.face; f < mesh.face + mesh.faces; f++) {
        f->n = fgetc(in);
        if (f->n < 3)
            fail("a face of less than three vertices");
        f->index = allocate((size_t)f->n, sizeof *f->index);
        read_numbers(f->index, sizeof *f->index, (size_t)f->n, in);
        for (int i = 0; i < f->n; i++)
            if (f->index[i] < 0 || f->index[i] >= mesh.vertices)
                fail("a face has a vertex that does not exist");
        if (mesh.has_nodes)
            read_numbers(&f->node, sizeof f->node, 1, in);
    }
    if (fgetc(in) != EOF)
        fail("the file is too long");
}

/* --- vertices --- */

static int by_place(const void *a, const void *b)
{
    const float *p = ((const struct vertex *)a)->at, *q = ((const struct vertex *)b)->at;
    for (int d = 0; d < 3; d++)
        if (p[d] != q[d])
            return p[d] < q[d] ? -1 : 1;
    return 0;
}

static void print_vertices(void)
{
    struct vertex *v = allocate((size_t)mesh.vertices, sizeof *v);
    char *used = allocate((size_t)mesh.vertices, 1);
    long equal = 0, unused = 0;
    double worst = 0, sum_z = 0;
    memcpy(v, mesh.vertex, (size_t)mesh.vertices * sizeof *v);
    qsort(v, (size_t)mesh.vertices, sizeof *v, by_place);
    for (long i = 1; i < mesh.vertices; i++)
        equal += by_place(&v[i], &v[i - 1]) == 0;
    for (struct face *f = mesh.face; f < mesh.face + mesh.faces; f++)
        for (int i = 0; i < f->n; i++)
            used[f->index[i]] = 1;
    for (long i = 0; i < mesh.vertices; i++) {
        const float *n = mesh.vertex[i].normal;
        double length = sqrt((double)n[0] * n[0] + (double)n[1] * n[1] + (double)n[2] * n[2]);
        worst = fmax(worst, fabs(length - 1));
        sum_z += n[2];
        unused += !used[i];
    }
    printf("vertices %ld\nat_equal_places %ld\nunused %ld\n", mesh.vertices, equal, unused);
    printf("normal_length_error %.9f\nmean_normal_z %.9f\n", worst, fabs(sum_z) / (double)mesh.vertices);
    free(v);
    free(used);
}

/* --- edges --- */

static int by_ends(const void *a, const void *b)
{
    const struct side *s = a, *t = b;
    if (s->from != t->from)
        return s->from < t->from ? -1 : 1;
    return (s->to > t->to) - (s->to < t->to);
}

static int is_on_border(const struct side *s)
{
    const float *a = mesh.vertex[s->from].at, *b = mesh.vertex[s->to].at;
    for (int d = 0; d < 3; d++)
        if (a[d] == b[d] && (a[d] == 0 || fabs(a[d] - box[d]) <= 1e-6 * box[d]))
            return has_box;
    return 0;
}

static long root_of(long *parent, long i)
{
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

static long pieces(const struct side *side, long sides)
{
    long *parent = allocate((size_t)mesh.vertices, sizeof *parent), n = 0;
    for (long i = 0; i < mesh.vertices; i++)
        parent[i] = i;
    for (long i = 0; i < sides; i++)
        parent[root_of(parent, side[i].from)] = root_of(parent, side[i].to);
    for (long i = 0; i < mesh.vertices; i++)
        n += parent[i] == i;
    free(parent);
    return n;
}

static struct side *sides_of_faces(long *n, long *shrunk)
{
    struct side *side;
    long corners = 0;
    for (long f = 0; f < mesh.faces; f++)
        corners += mesh.face[f].n;
    side = allocate((size_t)corners, sizeof *side);
    *n = *shrunk = 0;
    for (struct face *f = mesh.face; f < mesh.face + mesh.faces; f++)
        for (int i = 0; i < f->n; i++) {
            int a = f->index[i], b = f->index[(i + 1) % f->n];
            *shrunk += by_place(&mesh.vertex[a], &mesh.vertex[b]) == 0;
            side[(*n)++] = a < b ? (struct side){a, b, 1} : (struct side){b, a, -1};
        }
    qsort(side, (size_t)*n, sizeof *side, by_ends);
    return side;
}

static void print_edges(void)
{
    long sides, shrunk, edges = 0, open = 0, border = 0, shared = 0;
    struct side *side = sides_of_faces(&sides, &shrunk);
    for (long i = 0, j; i < sides; i = j) {
        int sum = 0;
        for (j = i; j < sides && by_ends(&side[i], &side[j]) == 0; j++)
            sum += side[j].direction;
        edges++;
        border += sum != 0 && is_on_border(&side[i]);
        open += sum != 0 && !is_on_border(&side[i]);
        shared += j - i > 2;
    }
    printf("faces %ld\nedges %ld\nof_no_length %ld\n", mesh.faces, edges, shrunk);
    printf("euler %ld\npieces %ld\n", mesh.vertices - edges + mesh.faces, pieces(side, sides));
    printf("open %ld\nborder %ld\nof_more_than_two_faces %ld\n", open, border, shared);
    free(side);
}

/* --- area and volume --- */

static void cross(const double a[3], const double b[3], double c[3])
{
    for (int d = 0; d < 3; d++)
        c[d] = a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* A face is the triangles between its sides and the mean of its vertices. Adds its area vector to `whole`. */
static void add_triangles(const struct face *f, double *area, double *volume, double whole[3])
{
    double middle[3] = {0};
    for (int i = 0; i < f->n; i++)
        for (int d = 0; d < 3; d++)
            middle[d] += mesh.vertex[f->index[i]].at[d] / (double)f->n;
    for (int i = 0; i < f->n; i++) {
        const float *p = mesh.vertex[f->index[i]].at, *q = mesh.vertex[f->index[(i + 1) % f->n]].at;
        double a[3], b[3], c[3];
        for (int d = 0; d < 3; d++) {
            a[d] = p[d] - middle[d];
            b[d] = q[d] - middle[d];
        }
        cross(a, b, c);
        *area += sqrt(dot(c, c)) / 2;
        *volume += dot(middle, c) / 6;
        for (int d = 0; d < 3; d++)
            whole[d] += c[d];
    }
}

static void print_area(void)
{
    double area = 0, volume = 0;
    long against = 0;
    for (struct face *f = mesh.face; f < mesh.face + mesh.faces; f++) {
        double whole[3] = {0}, sum[3] = {0};
        add_triangles(f, &area, &volume, whole);
        for (int i = 0; i < f->n; i++)
            for (int d = 0; d < 3; d++)
                sum[d] += mesh.vertex[f->index[i]].normal[d];
        against += dot(whole, sum) < 0;
    }
    printf("area %.6f\nvolume %.6f\nagainst_normals %ld\n", area, volume, against);
}

static void print_radius(void)
{
    double least = INFINITY, most = 0, angle = 0;
    for (long i = 0; i < mesh.vertices; i++) {
        double r[3], n[3], length;
        for (int d = 0; d < 3; d++) {
            r[d] = mesh.vertex[i].at[d] - centre[d];
            n[d] = mesh.vertex[i].normal[d];
        }
        length = sqrt(dot(r, r));
        least = fmin(least, length);
        most = fmax(most, length);
        angle = fmax(angle, acos(fmin(1, dot(r, n) / length)));
    }
    printf("radius_least %.6f\nradius_most %.6f\nnormal_off_degrees %.6f\n", least, most, angle * 180 / M_PI);
}

/* For each node that made faces: how many, and the least and greatest z of their vertices. */
static void print_nodes(void)
{
    enum { NODES = 1024 };
    static struct {
        long faces;
        double low, high;
    } made[NODES];
    for (struct face *f = mesh.face; f < mesh.face + mesh.faces; f++) {
        if (f->node < 0 || f->node >= NODES)
            fail("a face of a node that does not exist");
        for (int i = 0; i < f->n; i++) {
            double z = mesh.vertex[f->index[i]].at[2];
            made[f->node].low = made[f->node].faces ? fmin(made[f->node].low, z) : z;
            made[f->node].high = fmax(made[f->node].high, z);
        }
        made[f->node].faces++;
    }
    for (int i = 0; i < NODES; i++)
        if (made[i].faces)
            printf("node %d %ld %g %g\n", i, made[i].faces, made[i].low, made[i].high);
}

static void print_list(void)
{
    for (struct face *f = mesh.face; f < mesh.face + mesh.faces; f++) {
        int first = 0;
        for (int i = 1; i < f->n; i++)
            if (by_place(&mesh.vertex[f->index[i]], &mesh.vertex[f->index[first]]) < 0)
                first = i;
        for (int i = 0; i < f->n; i++) {
            const struct vertex *v = &mesh.vertex[f->index[(first + i) % f->n]];
            printf("%a %a %a %a %a %a ", v->at[0], v->at[1], v->at[2], v->normal[0], v->normal[1],
                   v->normal[2]);
        }
        printf("\n");
    }
}

static void read_three(char **from, double to[3])
{
    for (int d = 0; d < 3; d++)
        to[d] = from[d] ? atof(from[d]) : 0;
}

int main(int argc, char **argv)
{
    FILE *in = argc > 1 ? fopen(argv[1], "rb") : NULL;
    if (!in)
        fail("cannot read the file");
    read_mesh(in);
    for (int i = 2; i < argc; i++) {
        if (!strcmp(argv[i], "list")) {
            print_list();
            return 0;
        }
        if (!strcmp(argv[i], "box") && i + 3 < argc) {
            read_three(argv + i + 1, box);
            has_box = 1;
        }
        if (!strcmp(argv[i], "centre") && i + 3 < argc) {
            read_three(argv + i + 1, centre);
            has_centre = 1;
        }
    }
    print_vertices();
    print_edges();
    print_area();
    if (has_centre)
        print_radius();
    if (mesh.has_nodes)
        print_nodes();
    return 0;
}
