/* projection.h - a scene as a camera sees it: the corners of all triangles in the picture.
 *
 * Triangles and vertices of all surfaces are numbered through, in the order of the surfaces. */
#ifndef LAB_RENDER_PROJECTION_H
#define LAB_RENDER_PROJECTION_H
#include "lab/render/raster.h"
#include "lab/render/scene.h"

struct projection {
    const struct scene *scene;
    const struct camera *camera;
    uint32_t *first_vertex, *first_triangle; /* of each surface, and the ends */
    struct raster_corner *corner;            /* of each vertex */
};

/* samples: in a row of a pixel. Freed by projection_free(). */
struct projection projection_make(const struct scene *scene, const struct camera *camera, unsigned samples);
void projection_free(struct projection *p);

/* The surface that a triangle belongs to. */
size_t projection_surface(const struct projection *p, uint32_t triangle);

/* The corners of a triangle of a surface; triangle is numbered through. */
static inline void projection_corners(const struct projection *p, size_t surface, uint32_t triangle,
                                      struct raster_corner corner[3])
{
    const uint32_t *v = p->scene->surface[surface].mesh.triangle[triangle - p->first_triangle[surface]];
    for (int i = 0; i < 3; i++)
        corner[i] = p->corner[p->first_vertex[surface] + v[i]];
}
#endif
