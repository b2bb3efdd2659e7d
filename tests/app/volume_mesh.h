/* volume_mesh.h - for tests: all polygons of a small volume, and the edges of their mesh. */
#ifndef VOLUME_MESH_H
#define VOLUME_MESH_H
#include <stdbool.h>
#include <stddef.h>
#include "options.h"
#include "slice.h"

/* Options as from this command line, words separated by blanks. File names in them last until the next call.
 */
struct options options_of(const char *line);

/* The pixels of the whole volume, slice after slice: the sphere, or noise from a seed. */
pixel *volume_sphere(const struct grid *g);
pixel *volume_noise(const struct grid *g, unsigned seed, int levels);

/* Grid data (C0 or C3) of all slices, slice after slice. */
double *volume_data(const struct grid *g, const pixel *pixels);

/* Hand each polygon of the volume to out. */
void volume_polygons(const struct options *o, const pixel *pixels, polygon_fn *out);

/* The mesh of one surface: vertices at equal places, to the bit, are one. */
struct mesh_edges {
    size_t polygons, vertices, edges;
    size_t open;    /* edges within the volume that are not walked equally often in both directions */
    size_t borders; /* the same on the volume's border, where surfaces may end */
};

struct mesh_edges volume_mesh(const struct options *o, const pixel *pixels, int iso);
#endif
