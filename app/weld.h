/* weld.h - the vertices of two neighbouring layers, by position: vertices at equal positions get one number,
 * and the mean of their normals.
 *
 * The mean does not depend on the order in which corners come, to the bit: normals are added up as whole
 * numbers.
 */
#ifndef WELD_H
#define WELD_H
#include "part_file.h"

struct weld;

/* For at most `most` vertices at a time, or for as many as there is memory for. */
struct weld *weld_begin(long most);

/* The vertices that there is room for. */
long weld_room(const struct weld *w);

/* Forgets all vertices but those at this z. */
void weld_forget(struct weld *w, float z);

/* The number of the vertex at v's position; the next free number if there is no such vertex yet. The corner's
 * normal takes part in the mean there. -1: there is no room for a new one. */
long weld_add(struct weld *w, const part_vertex v);

/* Its number, or -1 if there is none. */
long weld_find(const struct weld *w, const part_vertex v);

/* A corner's normal takes part in the mean of the vertex at its position, if there is one, and no more. */
void weld_normal(struct weld *w, const part_vertex v);

/* The next free number; and give n numbers away without a vertex. */
long weld_next(const struct weld *w);
void weld_skip(struct weld *w, long n);

/* Vertex `nth` of those added since weld_forget, from 0 on, in the order of their numbers. Answers 0 after
 * the last. */
int weld_vertex(const struct weld *w, long nth, part_vertex v);

void weld_end(struct weld *w);

#endif
