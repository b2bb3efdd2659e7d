/* mesh.h - a surface of polygons: vertices, faces, and the same faces cut into triangles.
 *
 *   vertex   0 1 2 ...   place, and if the file has them: normal, colour
 *   face     0 1 2 ...   corners corner[first[f]] to corner[first[f + 1] - 1]
 *   triangle 0 1 2 ...   of face of_face[t]; a face of n corners has n - 2
 *
 * Faces are counter-clockwise, seen from the side to which the normals point. The arrays belong to the
 * mesh. */
#ifndef LAB_RENDER_MESH_H
#define LAB_RENDER_MESH_H
#include <stdint.h>

struct mesh {
    uint32_t vertex_count, face_count, triangle_count;
    float (*place)[3];
    float (*normal)[3];   /* of length 1, or 0 if unknown; NULL: none (mesh_normals.h makes them) */
    uint8_t (*colour)[3]; /* of vertices, sRGB; NULL: none */
    uint32_t *first;      /* face_count + 1 */
    uint32_t *corner;     /* numbers of vertices, each below vertex_count */
    uint32_t *node;       /* of each face: the node that made it; NULL: unknown */
    uint32_t (*triangle)[3];
    uint32_t *of_face;
};

/* Makes triangle, of_face and triangle_count from the faces. Each face has at least 3 corners. A face of 4 is
 * cut along its shorter diagonal, others from their first corner. */
void mesh_triangulate(struct mesh *m);

/* Frees what the mesh holds, not the struct, which is then empty. */
void mesh_free(struct mesh *m);
#endif
