/* weld.h - gives the vertices of polygons numbers, the same number to vertices at the same place. */
#ifndef WELD_H
#define WELD_H

typedef float weld_vertex[6]; /* x y z and normal */

struct weld;

/* Ready for at most `corners` vertices of polygons. Without memory for its table each corner becomes a vertex
 * of its own: the surface looks the same, and takes more room. */
struct weld *weld_begin(long corners);

/* The number of the vertex at v's place; the next free one when it has none yet. */
long weld_number(struct weld *w, const weld_vertex v);

/* The numbers given so far. */
long weld_vertices(const struct weld *w);

/* Go through the same vertices, in the same order, once more. */
void weld_restart(struct weld *w);

void weld_end(struct weld *w);

#endif
