/* marching_cubes.c - the isosurface of a volume by linear interpolation on the edges of cubes, for tests.
 *
 *     marching_cubes X Y Z STEP ISOVALUE <PIXELS
 *
 * Pixels have 8 bits, x fastest. Written without a look at app/: each cube's faces give segments, and the
 * segments are joined to loops. On a face of which two opposite corners lie below the isovalue, each of
 * them is cut off alone, as app/polygon.h says. Prints numbers of vertices, edges, loops and the Euler
 * number, the area and the volume of the same triangles as ply_facts.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static int points[3], step, pixels[3];
static double isovalue;
static unsigned char *level; /* at grid points */

static double at(const int p[3])
{
    return level[((long)p[2] * points[1] + p[1]) * points[0] + p[0]];
}

/* Along x and y a grid point is every step-th pixel, and the last; along z every slice. */
static double place(int i, int d)
{
    int pixel = d == 2 ? i : i * step;
    return pixel < pixels[d] - 1 ? pixel : pixels[d] - 1;
}

static void read_points(void)
{
    unsigned char *row = malloc((size_t)pixels[0]), *to;
    for (int d = 0; d < 3; d++)
        points[d] = d == 2 ? pixels[2] : (pixels[d] - 2) / step + 2;
    to = level = malloc((size_t)points[0] * (size_t)points[1] * (size_t)points[2]);
    for (int z = 0; z < pixels[2]; z++)
        for (int y = 0; y < pixels[1]; y++) {
            if (fread(row, 1, (size_t)pixels[0], stdin) != (size_t)pixels[0])
                exit(1);
            if (y % step == 0 || y == pixels[1] - 1)
                for (int i = 0; i < points[0]; i++)
                    *to++ = row[(int)place(i, 0)];
        }
    free(row);
}

/* A segment on a cube's face, between the crossed edges numbered by two corners a < b of the cube: 8 a +
 * b. */
struct segment {
    int from, to;
};

static int edge_number(int a, int b)
{
    return a < b ? 8 * a + b : 8 * b + a;
}

/* Corners of the face where coordinate d is `side`, in a ring whose sense, seen from outside, is the same
 * for all faces. */
static void face_ring(int d, int side, int ring[4])
{
    int e = 1 << (d + 1) % 3, f = 1 << (d + 2) % 3, at0 = side << d;
    int turn[4] = {at0, at0 | e, at0 | e | f, at0 | f};
    for (int i = 0; i < 4; i++)
        ring[i] = turn[side ? i : 3 - i];
}

/* Segments of a face: below corner runs are cut off, each run by one segment. */
static int face_segments(const int below[8], const int ring[4], struct segment *s)
{
    int n = 0;
    for (int i = 0; i < 4; i++)
        if (!below[ring[i]] && below[ring[(i + 1) % 4]]) {
            int k = i + 1;
            while (below[ring[(k + 1) % 4]])
                k++;
            s[n].from = edge_number(ring[i], ring[(i + 1) % 4]);
            s[n++].to = edge_number(ring[k % 4], ring[(k + 1) % 4]);
        }
    return n;
}

static void crossing(const int cube[3], int edge, double v[3])
{
    int a = edge / 8, b = edge % 8, p[3], q[3];
    double t;
    for (int d = 0; d < 3; d++) {
        p[d] = cube[d] + (a >> d & 1);
        q[d] = cube[d] + (b >> d & 1);
    }
    t = (isovalue - at(p)) / (at(q) - at(p));
    for (int d = 0; d < 3; d++)
        v[d] = place(p[d], d) + t * (place(q[d], d) - place(p[d], d));
}

static double area, volume;
static long loops, sides;

static void add_triangle(const double m[3], const double p[3], const double q[3])
{
    double a[3], b[3], c[3], sum = 0, along = 0;
    for (int d = 0; d < 3; d++) {
        a[d] = p[d] - m[d];
        b[d] = q[d] - m[d];
    }
    for (int d = 0; d < 3; d++) {
        c[d] = a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3];
        sum += c[d] * c[d];
        along += c[d] * m[d];
    }
    area += sqrt(sum) / 2;
    volume += along / 6;
}

static void add_loop(const int cube[3], const int *edge, int n)
{
    double v[12][3], middle[3] = {0};
    for (int i = 0; i < n; i++) {
        crossing(cube, edge[i], v[i]);
        for (int d = 0; d < 3; d++)
            middle[d] += v[i][d] / n;
    }
    for (int i = 0; i < n; i++)
        add_triangle(middle, v[i], v[(i + 1) % n]);
    loops++;
    sides += n;
}

static void do_cube(const int cube[3])
{
    struct segment s[12];
    int below[8], ring[4], n = 0;
    for (int c = 0; c < 8; c++) {
        int p[3] = {cube[0] + (c & 1), cube[1] + (c >> 1 & 1), cube[2] + (c >> 2)};
        below[c] = at(p) < isovalue;
    }
    for (int f = 0; f < 6; f++) {
        face_ring(f % 3, f / 3, ring);
        n += face_segments(below, ring, s + n);
    }
    while (n > 0) {
        int edge[12], m = 0, first = s[0].from, next = first;
        do
            for (int i = 0; i < n; i++)
                if (s[i].from == next) {
                    edge[m++] = next;
                    next = s[i].to;
                    s[i] = s[--n];
                    break;
                }
        while (next != first);
        add_loop(cube, edge, m);
    }
}

/* Each crossed grid edge has a vertex. */
static long count_vertices(void)
{
    long n = 0;
    int p[3];
    for (p[2] = 0; p[2] < points[2]; p[2]++)
        for (p[1] = 0; p[1] < points[1]; p[1]++)
            for (p[0] = 0; p[0] < points[0]; p[0]++)
                for (int d = 0; d < 3; d++) {
                    int q[3] = {p[0] + (d == 0), p[1] + (d == 1), p[2] + (d == 2)};
                    n += q[d] < points[d] && (at(p) < isovalue) != (at(q) < isovalue);
                }
    return n;
}

/* Sides of loops in the volume's border are edges of one loop, all others of two. */
static long border_segments(void)
{
    long n = 0;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            int e = (d + 1) % 3, f = (d + 2) % 3, p[3];
            for (int i = 0; i < points[e] - 1; i++)
                for (int j = 0; j < points[f] - 1; j++) {
                    int below[8], ring[4] = {0, 1, 3, 2};
                    struct segment s[4];
                    for (int c = 0; c < 4; c++) {
                        p[d] = side ? points[d] - 1 : 0;
                        p[e] = i + (c & 1);
                        p[f] = j + (c >> 1);
                        below[c] = at(p) < isovalue;
                    }
                    n += face_segments(below, ring, s);
                }
        }
    return n;
}

int main(int argc, char **argv)
{
    int cube[3];
    long vertices, edges;
    if (argc != 6)
        return 1;
    for (int d = 0; d < 3; d++)
        pixels[d] = atoi(argv[1 + d]);
    step = atoi(argv[4]);
    isovalue = atof(argv[5]);
    read_points();
    for (cube[2] = 0; cube[2] < points[2] - 1; cube[2]++)
        for (cube[1] = 0; cube[1] < points[1] - 1; cube[1]++)
            for (cube[0] = 0; cube[0] < points[0] - 1; cube[0]++)
                do_cube(cube);
    vertices = count_vertices();
    edges = (sides + border_segments()) / 2;
    printf("vertices %ld\neuler %ld\narea %.6f\nvolume %.6f\n", vertices, vertices - edges + loops, area,
           volume);
    return 0;
}
