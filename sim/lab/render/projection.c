/* projection.c - see projection.h. */
#include "lab/render/projection.h"
#include <math.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

static struct raster_corner corner_at(const struct camera *c, const float place[3], unsigned samples)
{
    struct camera_point at = camera_see(c, place);
    return (struct raster_corner){(int32_t)lrint(at.x * samples * RASTER_ONE),
                                  (int32_t)lrint(at.y * samples * RASTER_ONE), (float)(1 / at.depth)};
}

struct projection projection_make(const struct scene *scene, const struct camera *camera, unsigned samples)
{
    struct projection p = {scene, camera, NULL, NULL, NULL};
    p.first_vertex = xcalloc(scene->count + 1, sizeof *p.first_vertex);
    p.first_triangle = xcalloc(scene->count + 1, sizeof *p.first_triangle);
    for (size_t s = 0; s < scene->count; s++) {
        p.first_vertex[s + 1] = p.first_vertex[s] + scene->surface[s].mesh.vertex_count;
        p.first_triangle[s + 1] = p.first_triangle[s] + scene->surface[s].mesh.triangle_count;
    }
    p.corner = xreallocarray(NULL, p.first_vertex[scene->count], sizeof *p.corner);
    for (size_t s = 0; s < scene->count; s++)
        for (uint32_t v = 0; v < scene->surface[s].mesh.vertex_count; v++)
            p.corner[p.first_vertex[s] + v] = corner_at(camera, scene->surface[s].mesh.place[v], samples);
    return p;
}

void projection_free(struct projection *p)
{
    free(p->first_vertex);
    free(p->first_triangle);
    free(p->corner);
}

size_t projection_surface(const struct projection *p, uint32_t triangle)
{
    size_t s = 0;
    while (triangle >= p->first_triangle[s + 1])
        s++;
    return s;
}
