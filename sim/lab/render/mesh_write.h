/* mesh_write.h - surfaces as files of other programs. The name's ending decides:
 *
 *   .ply   binary, little-endian; several surfaces: faces have their number as property surface
 *   .obj   Wavefront's text; a group a surface
 *   .stl   binary, triangles only: neither normals of vertices, nor nodes, nor colours
 *   .vtk   VTK's legacy format, binary: normals; surface and node are data of the cells
 */
#ifndef LAB_RENDER_MESH_WRITE_H
#define LAB_RENDER_MESH_WRITE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include "lab/render/mesh.h"

struct mesh_writer; /* a format */

/* The format of that ending, whatever its case; NULL: none. */
const struct mesh_writer *mesh_writer(const char *path);

/* Writes surfaces as one file. name: of each, for formats with names. A property is written if all surfaces
 * have it. False with *error malloc'd: they have more vertices than the format can count. Whether all was
 * written, out knows (ferror). */
bool mesh_write(const struct mesh_writer *writer, const struct mesh *const *mesh, const char *const *name,
                size_t count, FILE *out, char **error);
#endif
