/* shade.c - see shade.h. */
#include "lab/render/shade.h"
#include <math.h>

static const float LEAST_FACING = 0.05f;

static float dot(const float a[3], const float b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalise(float v[3])
{
    float length = sqrtf(dot(v, v));
    for (int i = 0; i < 3 && length > 0; i++)
        v[i] /= length;
}

/* The way from a sample to the viewer, in the camera's axes. */
static void view_from(const struct camera *c, int32_t x, int32_t y, unsigned samples, float view[3])
{
    view[0] = (float)((c->x - ((double)x + 0.5) / samples) / c->scale);
    view[1] = (float)((((double)y + 0.5) / samples - c->y) / c->scale);
    view[2] = 1;
    normalise(view);
}

/* The plane of a triangle, as its order of corners gives it, in the scene's axes. */
static void plane_of(const struct mesh *m, const uint32_t v[3], float n[3])
{
    double u[3], w[3];
    for (int i = 0; i < 3; i++) {
        u[i] = (double)m->place[v[1]][i] - (double)m->place[v[0]][i];
        w[i] = (double)m->place[v[2]][i] - (double)m->place[v[0]][i];
    }
    for (int i = 0; i < 3; i++)
        n[i] = (float)(u[(i + 1) % 3] * w[(i + 2) % 3] - u[(i + 2) % 3] * w[(i + 1) % 3]);
    normalise(n);
}

/* Turns the normal to the viewer. Near the outline an interpolated normal may point a little away although
 * the triangle's front is seen; there the triangle's plane decides, and the normal is bent back: else the
 * outline would have speckles. */
static void face_viewer(const struct camera *c, const struct mesh *m, const uint32_t v[3],
                        struct shade_point *at)
{
    float sign = at->facing = dot(at->normal, at->view);
    if (fabsf(at->facing) < 0.3f) {
        float plane[3], turned[3];
        plane_of(m, v, plane);
        camera_turn(c, plane, turned);
        if (dot(turned, turned) > 0)
            sign = dot(turned, at->view) * (dot(turned, at->normal) < 0 ? -1 : 1);
    }
    if (sign < 0) {
        at->facing = -at->facing;
        for (int i = 0; i < 3; i++)
            at->normal[i] = -at->normal[i];
    }
    if (at->facing < LEAST_FACING) {
        for (int i = 0; i < 3; i++)
            at->normal[i] += (LEAST_FACING - at->facing) * at->view[i];
        normalise(at->normal);
        at->facing = LEAST_FACING;
    }
}

static void colour_of(const struct scene *scene, const struct scene_surface *s, uint32_t triangle,
                      const float weight[3], float colour[3])
{
    const struct mesh *m = &s->mesh;
    const float *whole = s->colour;
    if (s->colouring == SCENE_BY_NODE)
        whole = scene->node_colour[m->node[m->of_face[triangle]] % SCENE_NODE_COLOURS];
    for (int i = 0; i < 3; i++) {
        colour[i] = s->colouring == SCENE_BY_VERTEX ? 0 : whole[i];
        for (int k = 0; k < 3 && s->colouring == SCENE_BY_VERTEX; k++)
            colour[i] += weight[k] * scene->linear[m->colour[m->triangle[triangle][k]][i]];
    }
}

struct shade_point shade_point(const struct projection *p, uint32_t triangle, int32_t x, int32_t y,
                               unsigned samples)
{
    struct shade_point at = {.surface = projection_surface(p, triangle)};
    const struct scene_surface *s = &p->scene->surface[at.surface];
    const uint32_t own = triangle - p->first_triangle[at.surface], *v = s->mesh.triangle[own];
    struct raster_corner corner[3];
    float weight[3], normal[3] = {0, 0, 0};
    projection_corners(p, at.surface, triangle, corner);
    raster_weights(corner, x, y, weight);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            normal[i] += weight[k] * s->mesh.normal[v[k]][i];
    if (!(dot(normal, normal) > 0))
        plane_of(&s->mesh, v, normal);
    camera_turn(p->camera, normal, at.normal);
    normalise(at.normal);
    view_from(p->camera, x, y, samples, at.view);
    face_viewer(p->camera, &s->mesh, v, &at);
    colour_of(p->scene, s, own, weight, at.colour);
    return at;
}

/* Lights that stay with the camera, in its axes: a strong one from above on the left, a weak one from the
 * right, one from behind that draws the outline. */
static const struct {
    float way[3]; /* to the light, of length 1 */
    float strength[3];
} LIGHTS[] = {{{-0.57f, 0.57f, 0.59f}, {0.82f, 0.80f, 0.77f}},
              {{0.80f, 0.05f, 0.60f}, {0.13f, 0.14f, 0.16f}},
              {{0.25f, 0.60f, -0.76f}, {0.30f, 0.31f, 0.33f}}};
static const float SKY[3] = {0.20f, 0.21f, 0.22f}, GROUND[3] = {0.10f, 0.095f, 0.09f};
static const float GLOSS = 0.16f;

/* Blinn's highlight (1977) of a light, with an exponent of 32. */
static float highlight(const struct shade_point *at, const float way[3])
{
    float half[3];
    for (int i = 0; i < 3; i++)
        half[i] = way[i] + at->view[i];
    normalise(half);
    float h = dot(half, at->normal);
    if (h <= 0)
        return 0;
    for (int i = 0; i < 5; i++)
        h *= h;
    return h;
}

void shade_light(const struct shade_point *at, float open, float light[3])
{
    float sky = 0.5f + 0.5f * at->normal[1], direct = 0.35f + 0.65f * open;
    for (int i = 0; i < 3; i++)
        light[i] = at->colour[i] * open * (sky * SKY[i] + (1 - sky) * GROUND[i]);
    for (size_t k = 0; k < sizeof LIGHTS / sizeof *LIGHTS; k++) {
        float falls = dot(at->normal, LIGHTS[k].way);
        if (falls <= 0)
            continue;
        float gloss = GLOSS * highlight(at, LIGHTS[k].way);
        for (int i = 0; i < 3; i++)
            light[i] += direct * LIGHTS[k].strength[i] * (falls * at->colour[i] + gloss);
    }
}

float shade_opacity(const struct shade_point *at, float opacity)
{
    return opacity >= 1 ? 1 : 1 - powf(1 - opacity, 1 / at->facing);
}
