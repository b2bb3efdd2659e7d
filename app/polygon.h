/* polygon.h - closed polygons of an isosurface in one cube, from the crossings of its edges.
 *
 * Corner x + 2 y + 4 z of a cube is at (x, y, z), each 0 or 1. Edge 4 d + r runs along axis d (0 x, 1 y, 2 z)
 * from its lower to its upper corner; r orders the four edges of one axis by their lower corner.
 */
#ifndef POLYGON_H
#define POLYGON_H

#define POLYGON_MAX 6 /* vertices of a polygon; longer ones are split */

typedef double vertex[6]; /* x y z in pixels, then the unit normal: the direction in which F rises */

/* Receives each polygon of isovalue number iso: n = 3 .. POLYGON_MAX vertices. */
typedef void polygon_fn(int iso, int n, const vertex *v);

/* The two corners of each edge. */
extern const int polygon_edge[12][2];

/* Link the crossings of a cube into polygons. Bit c of inside: F is below the isovalue in corner c.
 * at_edge[e] is the surface's vertex on edge e, read only if one end of e is inside. Vertices run
 * counterclockwise around the normals. On a face with two inside corners at opposite ends of a diagonal each
 * corner is cut off alone. This rule depends on the face's corners only, so that both cubes at a face agree
 * and the surface has no gaps. */
void polygon_link(unsigned inside, const vertex *const at_edge[12], int iso, polygon_fn *out);

/* Scale a normal to unit length; a vanishing one becomes (0, 0, 1). */
void polygon_normalise(double n[3]);

#endif
