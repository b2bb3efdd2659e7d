/* occlusion.c - see occlusion.h. */
#include "lab/render/occlusion.h"
#include <math.h>
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lab/render/layers.h"
#include "lab/render/shade.h"

enum { TAPS = 20, BLUR = 2 };

/* Places further away than this hide nothing, in radii of the scene: wide for the shape, narrow for folds. */
static const float REACH[] = {0.16f, 0.04f};
static const float STRENGTH = 0.9f;

struct occlusion {
    int32_t width, height;
    float *open; /* of each pixel */
    float *near; /* 1 / depth; 0: nothing is there */
    float radius;
};

/* Where each pixel is seen, in the camera's axes, and its normal. */
struct seen {
    float (*place)[3], (*normal)[3];
};

static void draw_opaque(const struct scene *scene, const struct projection *p, struct layers *l)
{
    for (size_t s = 0; s < scene->count; s++)
        for (uint32_t t = p->first_triangle[s];
             t < p->first_triangle[s + 1] && scene->surface[s].opacity >= 1; t++) {
            struct raster_corner corner[3];
            projection_corners(p, s, t, corner);
            layers_opaque(l, corner, t);
        }
}

static struct seen see(const struct scene *scene, const struct camera *c, struct occlusion *o)
{
    struct projection p = projection_make(scene, c, 1);
    struct layers *l = layers_new((struct raster_window){0, 0, o->width, o->height});
    struct seen seen = {xcalloc(l->samples, sizeof *seen.place), xcalloc(l->samples, sizeof *seen.normal)};
    draw_opaque(scene, &p, l);
    for (size_t i = 0; i < l->samples; i++) {
        o->near[i] = l->opaque[i].near;
        if (l->opaque[i].triangle == LAYERS_NONE)
            continue;
        int32_t x = (int32_t)i % o->width, y = (int32_t)i / o->width;
        struct shade_point at = shade_point(&p, l->opaque[i].triangle, x, y, 1);
        float depth = 1 / o->near[i];
        for (int k = 0; k < 3; k++) {
            seen.place[i][k] = -at.view[k] / at.view[2] * depth;
            seen.normal[i][k] = at.normal[k];
        }
    }
    layers_free(l);
    projection_free(&p);
    return seen;
}

static float dot(const float a[3], const float b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* How much the place of pixel `other` hides of the light at pixel i. */
static float hidden_by(const struct seen *seen, size_t i, size_t other, float reach)
{
    float way[3];
    for (int k = 0; k < 3; k++)
        way[k] = (seen->place[other][k] - seen->place[i][k]) / reach;
    float square = dot(way, way), rises = dot(way, seen->normal[i]) - 0.02f;
    if (square >= 1 || rises <= 0)
        return 0;
    float falloff = 1 - square;
    return falloff * falloff * falloff * rises / (square + 0.01f);
}

/* A number from 0 to 1 for each pixel: where its taps begin. */
static float turn_of(int32_t x, int32_t y)
{
    uint32_t h = (uint32_t)x * 0x9e3779b1u ^ (uint32_t)y * 0x85ebca77u;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    return (float)((h ^ h >> 13) & 0xffff) / 65536;
}

/* The taps lie on a spiral around the pixel. */
static float open_at(const struct occlusion *o, const struct seen *seen, int32_t x, int32_t y, float reach,
                     float pixels)
{
    size_t i = (size_t)y * (size_t)o->width + (size_t)x;
    float sum = 0, turn = turn_of(x, y);
    for (int tap = 0; tap < TAPS; tap++) {
        float from = ((float)tap + turn) / TAPS * pixels,
              angle = 2 * (float)M_PI * (turn + (float)tap * 0.618034f);
        int32_t u = x + (int32_t)lrintf(from * cosf(angle)), v = y + (int32_t)lrintf(from * sinf(angle));
        if (u < 0 || v < 0 || u >= o->width || v >= o->height)
            continue;
        size_t other = (size_t)v * (size_t)o->width + (size_t)u;
        if (o->near[other] > 0 && other != i)
            sum += hidden_by(seen, i, other, reach);
    }
    float open = 1 - STRENGTH * 2 * sum / TAPS;
    return open > 0 ? open : 0;
}

static void judge(struct occlusion *o, const struct seen *seen, float scale)
{
    for (int32_t y = 0; y < o->height; y++)
        for (int32_t x = 0; x < o->width; x++) {
            size_t i = (size_t)y * (size_t)o->width + (size_t)x;
            o->open[i] = 1;
            for (size_t k = 0; k < sizeof REACH / sizeof *REACH && o->near[i] > 0; k++) {
                float reach = REACH[k] * o->radius, pixels = reach * scale * o->near[i];
                if (pixels > 1)
                    o->open[i] *= open_at(o, seen, x, y, reach, pixels);
            }
        }
}

/* Do two depths belong to one place of a surface? */
static bool is_near(const struct occlusion *o, float a, float b)
{
    return a > 0 && b > 0 && fabsf(1 / a - 1 / b) < 0.04f * o->radius;
}

static float mean_around(const struct occlusion *o, int32_t x, int32_t y, float near, int32_t around)
{
    float sum = 0, count = 0;
    for (int32_t v = y - around; v <= y + around; v++)
        for (int32_t u = x - around; u <= x + around; u++) {
            size_t i = (size_t)v * (size_t)o->width + (size_t)u;
            if (u >= 0 && v >= 0 && u < o->width && v < o->height && is_near(o, o->near[i], near)) {
                sum += o->open[i];
                count++;
            }
        }
    return count > 0 ? sum / count : 1;
}

static void blur(struct occlusion *o)
{
    size_t pixels = (size_t)o->width * (size_t)o->height;
    float *smooth = xreallocarray(NULL, pixels, sizeof *smooth);
    for (size_t i = 0; i < pixels; i++)
        smooth[i] = mean_around(o, (int32_t)(i % (size_t)o->width), (int32_t)(i / (size_t)o->width),
                                o->near[i], BLUR);
    free(o->open);
    o->open = smooth;
}

struct occlusion *occlusion_make(const struct scene *scene, const struct camera *camera, uint32_t width,
                                 uint32_t height)
{
    struct occlusion *o = xmalloc(sizeof *o);
    size_t pixels = (size_t)width * height;
    *o = (struct occlusion){(int32_t)width, (int32_t)height, xreallocarray(NULL, pixels, sizeof *o->open),
                            xreallocarray(NULL, pixels, sizeof *o->near), (float)scene_ball(scene).radius};
    struct seen seen = see(scene, camera, o);
    judge(o, &seen, (float)camera->scale);
    blur(o);
    free(seen.place);
    free(seen.normal);
    return o;
}

void occlusion_free(struct occlusion *o)
{
    free(o->open);
    free(o->near);
    free(o);
}

float occlusion_open(const struct occlusion *o, int32_t x, int32_t y, float near)
{
    size_t i = (size_t)y * (size_t)o->width + (size_t)x;
    return is_near(o, o->near[i], near) ? o->open[i] : mean_around(o, x, y, near, 1);
}
