/* mesh_weld.h - joins vertices that are at the same place. */
#ifndef LAB_RENDER_MESH_WELD_H
#define LAB_RENDER_MESH_WELD_H
#include "lab/render/mesh.h"

/* A number for each vertex: vertices at exactly one place have one number. Numbers are counted from 0 in the
 * order of the vertices; *places is how many there are. The caller frees the array. */
uint32_t *mesh_weld_numbers(const struct mesh *m, uint32_t *places);

/* Joins the vertices at each place: the normal becomes the mean of theirs, the colour that of the first. */
void mesh_weld(struct mesh *m);
#endif
