/* ball_mesh.h - surfaces for tests of pictures: balls, and a flat sheet, as meshes. */
#ifndef TESTS_BALL_MESH_H
#define TESTS_BALL_MESH_H
#include <math.h>
#include <stdbool.h>
#include "kernel/xalloc.h"
#include "lab/render/mesh.h"

/* Makes room for a mesh of triangles without normals; faces are numbered as they are added. */
static inline struct mesh mesh_room(uint32_t vertices, uint32_t triangles)
{
    struct mesh m = {.place = xcalloc(vertices, sizeof *m.place),
                     .first = xcalloc(triangles + 1, sizeof *m.first),
                     .corner = xcalloc(3 * (size_t)triangles, sizeof *m.corner)};
    return m;
}

static inline void mesh_add(struct mesh *m, uint32_t a, uint32_t b, uint32_t c)
{
    uint32_t *corner = m->corner + 3 * m->face_count;
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
    m->face_count++;
    m->first[m->face_count] = 3 * m->face_count;
}

/* A ball of n x 2n fields, counter-clockwise from outside; with normals, or without. */
static inline struct mesh ball_mesh(float x, float y, float z, float radius, uint32_t n, bool normals)
{
    uint32_t around = 2 * n;
    struct mesh m = mesh_room((n + 1) * around, 2 * n * around);
    m.vertex_count = (n + 1) * around;
    m.normal = normals ? xcalloc(m.vertex_count, sizeof *m.normal) : NULL;
    for (uint32_t v = 0; v < m.vertex_count; v++) {
        double down = M_PI * (v / around) / n, turn = 2 * M_PI * (v % around) / around;
        const float way[3] = {(float)(sin(down) * cos(turn)), (float)(sin(down) * sin(turn)),
                              (float)cos(down)};
        const float middle[3] = {x, y, z};
        for (int i = 0; i < 3; i++) {
            m.place[v][i] = middle[i] + radius * way[i];
            if (normals)
                m.normal[v][i] = way[i];
        }
    }
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = 0; j < around; j++) {
            uint32_t a = i * around + j, b = i * around + (j + 1) % around;
            if (i > 0)
                mesh_add(&m, a, a + around, b);
            if (i + 1 < n)
                mesh_add(&m, b, a + around, b + around);
        }
    mesh_triangulate(&m);
    return m;
}

/* A square of n x n fields in the plane y = 0, from -1 to 1, whose inner vertices lie at odd places. */
static inline struct mesh sheet_mesh(uint32_t n)
{
    struct mesh m = mesh_room((n + 1) * (n + 1), 2 * n * n);
    m.vertex_count = (n + 1) * (n + 1);
    for (uint32_t v = 0; v < m.vertex_count; v++) {
        uint32_t i = v % (n + 1), j = v / (n + 1);
        bool inner = i > 0 && i < n && j > 0 && j < n;
        m.place[v][0] = (float)(2.0 * i / n - 1 + inner * 0.3 / n * sin(7.0 * v));
        m.place[v][2] = (float)(2.0 * j / n - 1 + inner * 0.3 / n * cos(5.0 * v));
    }
    for (uint32_t j = 0; j < n; j++)
        for (uint32_t i = 0; i < n; i++) {
            uint32_t a = j * (n + 1) + i;
            mesh_add(&m, a, a + 1, a + n + 1);
            mesh_add(&m, a + 1, a + n + 2, a + n + 1);
        }
    mesh_triangulate(&m);
    return m;
}
#endif
