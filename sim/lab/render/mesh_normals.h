/* mesh_normals.h - normals of a mesh whose file has none. */
#ifndef LAB_RENDER_MESH_NORMALS_H
#define LAB_RENDER_MESH_NORMALS_H
#include "lab/render/mesh.h"

/* Unless the mesh has normals, makes them: at each place the sum of the triangles' normals, weighted by area.
 * Vertices at one place share it, so that a mesh of separate faces looks smooth, too. */
void mesh_normals(struct mesh *m);
#endif
