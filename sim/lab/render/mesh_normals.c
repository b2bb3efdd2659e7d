/* mesh_normals.c - see mesh_normals.h. */
#include "lab/render/mesh_normals.h"
#include <math.h>
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lab/render/mesh_weld.h"

/* The normal of a triangle; its length is twice the area. */
static void across(const float a[3], const float b[3], const float c[3], double n[3])
{
    double u[3], v[3];
    for (int i = 0; i < 3; i++) {
        u[i] = (double)b[i] - (double)a[i];
        v[i] = (double)c[i] - (double)a[i];
    }
    for (int i = 0; i < 3; i++)
        n[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
}

void mesh_normals(struct mesh *m)
{
    if (m->normal)
        return;
    uint32_t places, *number = mesh_weld_numbers(m, &places);
    double(*sum)[3] = xcalloc(places, sizeof *sum);
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        const uint32_t *v = m->triangle[t];
        double n[3];
        across(m->place[v[0]], m->place[v[1]], m->place[v[2]], n);
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 3; i++)
                sum[number[v[k]]][i] += n[i];
    }
    m->normal = xmalloc(m->vertex_count * sizeof *m->normal);
    for (uint32_t v = 0; v < m->vertex_count; v++) {
        const double *n = sum[number[v]];
        double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int i = 0; i < 3; i++)
            m->normal[v][i] = length > 0 ? (float)(n[i] / length) : 0;
    }
    free(sum);
    free(number);
}
