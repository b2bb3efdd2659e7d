/* weld.h - numbers the vertices of polygons; vertices at equal positions get one number. */
#ifndef WELD_H
#define WELD_H

typedef float weld_vertex[6]; /* x y z and normal */

struct weld;

/* For at most `corners` corners of polygons. If there is no memory for the table, each corner becomes a
 * vertex of its own: the surface looks the same, but its file is larger. */
struct weld *weld_begin(long corners);

/* The number of the vertex at v's position; the next free number if there is no such vertex yet. */
long weld_number(struct weld *w, const weld_vertex v);

/* How many numbers were given so far. */
long weld_vertices(const struct weld *w);

/* To be called before the caller numbers all corners once more, in unchanged order. */
void weld_restart(struct weld *w);

void weld_end(struct weld *w);

#endif
