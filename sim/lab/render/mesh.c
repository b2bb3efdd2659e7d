/* mesh.c - see mesh.h. */
#include "lab/render/mesh.h"
#include <stdbool.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

static double square_distance(const struct mesh *m, uint32_t a, uint32_t b)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        double d = (double)m->place[a][i] - (double)m->place[b][i];
        sum += d * d;
    }
    return sum;
}

static bool cut_from_second(const struct mesh *m, const uint32_t *corner, uint32_t corners)
{
    return corners == 4 &&
           square_distance(m, corner[1], corner[3]) < square_distance(m, corner[0], corner[2]);
}

void mesh_triangulate(struct mesh *m)
{
    uint32_t corners = m->first[m->face_count], t = 0;
    m->triangle_count = corners - 2 * m->face_count;
    m->triangle = xmalloc(m->triangle_count * sizeof *m->triangle);
    m->of_face = xmalloc(m->triangle_count * sizeof *m->of_face);
    for (uint32_t f = 0; f < m->face_count; f++) {
        const uint32_t *corner = m->corner + m->first[f], n = m->first[f + 1] - m->first[f];
        uint32_t begin = cut_from_second(m, corner, n);
        for (uint32_t i = 1; i + 1 < n; i++, t++) {
            m->triangle[t][0] = corner[begin];
            m->triangle[t][1] = corner[(begin + i) % n];
            m->triangle[t][2] = corner[(begin + i + 1) % n];
            m->of_face[t] = f;
        }
    }
}

void mesh_free(struct mesh *m)
{
    free(m->place);
    free(m->normal);
    free(m->colour);
    free(m->first);
    free(m->corner);
    free(m->node);
    free(m->triangle);
    free(m->of_face);
    *m = (struct mesh){0};
}
