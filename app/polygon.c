/* polygon.c - links edge crossings into polygons; see polygon.h.
 *
 * Walk around each face counterclockwise, seen from outside the cube. Each edge where the walk enters the
 * inside is linked to the edge where the walk next leaves the inside. An edge belongs to two faces, whose
 * walks pass it in opposite directions: every crossed edge has exactly one link from it and one to it, and
 * the links close to loops.
 */
#include <math.h>
#include <string.h>
#include "polygon.h"

const int polygon_edge[12][2] = {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3},
                                 {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};

/* Corners of the faces, counterclockwise from outside, and the edge from each corner to the next. */
static const int face_corner[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
static const int face_edge[6][4] = {{8, 6, 10, 4},  {5, 11, 7, 9}, {0, 9, 2, 8},
                                    {10, 3, 11, 1}, {4, 1, 5, 0},  {2, 7, 3, 6}};

static void link_face(unsigned inside, const int *corner, const int *edge, int next[12])
{
    int i, k;

    for (i = 0; i < 4; i++)
        if (!(inside >> corner[i] & 1) && inside >> corner[(i + 1) & 3] & 1) {
            for (k = (i + 1) & 3; inside >> corner[(k + 1) & 3] & 1; k = (k + 1) & 3)
                ;
            next[edge[i]] = edge[k];
        }
}

/* Give a loop of n vertices to out, as polygons of at most POLYGON_MAX vertices. */
static void hand_out(const vertex *loop, int n, int iso, polygon_fn *out)
{
    vertex piece[12];

    memcpy(piece, loop, n * sizeof *piece);
    while (n > POLYGON_MAX) {
        out(iso, POLYGON_MAX, piece);
        n -= POLYGON_MAX - 2; /* the rest shares the chord between the first and the last vertex */
        memmove(piece[1], piece[POLYGON_MAX - 1], (n - 1) * sizeof *piece);
    }
    out(iso, n, piece);
}

void polygon_link(unsigned inside, const vertex *const at_edge[12], int iso, polygon_fn *out)
{
    int next[12], e, at, n;
    vertex loop[12];

    if (inside == 0 || inside == 255)
        return;
    for (e = 0; e < 12; e++)
        next[e] = -1;
    for (e = 0; e < 6; e++)
        link_face(inside, face_corner[e], face_edge[e], next);
    for (e = 0; e < 12; e++) {
        for (n = 0, at = e; next[at] >= 0; n++) {
            int from = at;

            memcpy(loop[n], *at_edge[at], sizeof *loop);
            at = next[at];
            next[from] = -1;
        }
        if (n > 0)
            hand_out(loop, n, iso, out);
    }
}

void polygon_normalise(double n[3])
{
    double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);

    if (length > 0) {
        n[0] /= length;
        n[1] /= length;
        n[2] /= length;
    } else {
        n[0] = n[1] = 0;
        n[2] = 1;
    }
}
