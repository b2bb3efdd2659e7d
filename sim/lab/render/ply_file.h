/* ply_file.h - reads a surface from a PLY file: ascii or binary of either byte order, properties in any
 * order, other elements and properties passed over.
 *
 *   element vertex: x y z; nx ny nz, if there; red green blue, if there (integers to 255, or floats to 1)
 *   element face:   list vertex_indices (or vertex_index); node, if there: the node that made the polygon
 */
#ifndef LAB_RENDER_PLY_FILE_H
#define LAB_RENDER_PLY_FILE_H
#include <stdbool.h>
#include "lab/render/mesh.h"

/* Reads the whole file; "-" is standard input. The caller frees the mesh, which is triangulated. False with
 * *error malloc'd: it names the file, and the line (in a head or in ascii) or the byte where it is wrong.
 * Wrong are a file that is cut short, a face that names no vertex or has fewer than 3, a coordinate that is
 * not finite, and lengths that the file cannot hold. */
bool ply_file_read(const char *path, struct mesh *mesh, char **error);
#endif
