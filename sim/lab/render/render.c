/* render.c - see render.h. */
#include "lab/render/render.h"
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lab/render/bands.h"
#include "lab/render/colours.h"
#include "lab/render/layers.h"
#include "lab/render/occlusion.h"
#include "lab/render/shade.h"

enum { S = RENDER_SAMPLES, BAND_SAMPLES = 1 << 19, LIT = 64 };

/* The light from a triangle in a pixel: computed at one sample of the pixel, used at all. */
struct lit {
    uint32_t triangle, pixel; /* pixel: its number, from 1 on; 0: none */
    float light[3], opacity;
};

struct drawing {
    const struct scene *scene;
    struct projection projection;
    struct occlusion *occlusion;
    struct layers *layers;
    struct image *image;
    struct lit lit[LIT]; /* triangle t is at t % LIT */
};

static struct lit shine(const struct drawing *d, const struct layer *l, int32_t x, int32_t y, uint32_t pixel)
{
    struct shade_point at = shade_point(&d->projection, l->triangle, x, y, S);
    struct lit lit = {.triangle = l->triangle, .pixel = pixel};
    float opacity = d->scene->surface[at.surface].opacity;
    shade_light(&at, opacity >= 1 ? occlusion_open(d->occlusion, x / S, y / S, l->near) : 1, lit.light);
    lit.opacity = shade_opacity(&at, opacity);
    return lit;
}

/* Adds one triangle's light, of which `left` gets through to the viewer. */
static void add_light(struct drawing *d, const struct layer *l, int32_t x, int32_t y, float sum[4],
                      float *left)
{
    uint32_t pixel = (uint32_t)(y / S) * d->image->width + (uint32_t)(x / S) + 1;
    struct lit *lit = &d->lit[l->triangle % LIT];
    if (lit->pixel != pixel || lit->triangle != l->triangle)
        *lit = shine(d, l, x, y, pixel);
    for (int i = 0; i < 3; i++)
        sum[i] += *left * lit->opacity * lit->light[i];
    sum[3] += *left * lit->opacity;
    *left *= 1 - lit->opacity;
}

static void add_background(const struct drawing *d, int32_t y, float sum[4], float left)
{
    float down = ((float)y + 0.5f) / (float)(d->image->height * S);
    if (!d->scene->has_background)
        return;
    for (int i = 0; i < 3; i++)
        sum[i] += left * (d->scene->background_top[i] * (1 - down) + d->scene->background_bottom[i] * down);
    sum[3] += left;
}

/* Adds what is seen at one sample, from the front to the back. */
static void add_sample(struct drawing *d, const struct layer *sample, int32_t x, int32_t y, float sum[4])
{
    float left = 1;
    for (uint32_t i = sample->next; i != LAYERS_NONE && left > 1 / 1024.0f; i = d->layers->pool[i].next)
        add_light(d, &d->layers->pool[i], x, y, sum, &left);
    if (sample->triangle != LAYERS_NONE)
        add_light(d, sample, x, y, sum, &left);
    else
        add_background(d, y, sum, left);
}

static void draw_pixel(struct drawing *d, uint32_t x, uint32_t y)
{
    const size_t width = (size_t)d->image->width * S;
    float sum[4] = {0, 0, 0, 0};
    for (uint32_t j = y * S; j < (y + 1) * S; j++)
        for (uint32_t i = x * S; i < (x + 1) * S; i++)
            add_sample(d, &d->layers->opaque[(j - (uint32_t)d->layers->window.top) * width + i], (int32_t)i,
                       (int32_t)j, sum);
    uint8_t *pixel = d->image->rgba + 4 * ((size_t)y * d->image->width + x);
    for (int i = 0; i < 3; i++)
        pixel[i] = sum[3] > 0 ? colours_srgb(sum[i] / sum[3]) : 0;
    pixel[3] = (uint8_t)(sum[3] * 255 / (S * S) + 0.5f);
}

static void put_triangles(struct drawing *d, const struct bands *bands, size_t band, bool opaque)
{
    for (size_t i = bands->first[band]; i < bands->first[band + 1]; i++) {
        struct raster_corner corner[3];
        size_t surface = projection_surface(&d->projection, bands->triangle[i]);
        float opacity = d->scene->surface[surface].opacity;
        if (opacity <= 0 || (opacity >= 1) != opaque)
            continue;
        projection_corners(&d->projection, surface, bands->triangle[i], corner);
        if (opaque)
            layers_opaque(d->layers, corner, bands->triangle[i]);
        else
            layers_transparent(d->layers, corner, bands->triangle[i]);
    }
}

/* Draws the rows of pixels from top to bottom - 1. */
static void draw_band(struct drawing *d, const struct bands *bands, size_t band, uint32_t top,
                      uint32_t bottom)
{
    layers_clear(d->layers, (int32_t)top * S);
    put_triangles(d, bands, band, true);
    put_triangles(d, bands, band, false);
    for (uint32_t y = top; y < bottom; y++)
        for (uint32_t x = 0; x < d->image->width; x++)
            draw_pixel(d, x, y);
}

void render(const struct scene *scene, const struct camera *camera, struct image *image)
{
    struct drawing d = {.scene = scene, .projection = projection_make(scene, camera, S), .image = image};
    uint32_t rows = BAND_SAMPLES / (image->width * S * S);
    rows = rows < 1 ? 1 : rows > image->height ? image->height : rows;
    struct bands bands = bands_make(&d.projection, (int32_t)rows * S, (int32_t)image->height * S);
    d.occlusion = occlusion_make(scene, camera, image->width, image->height);
    d.layers = layers_new((struct raster_window){0, 0, (int32_t)image->width * S, (int32_t)rows * S});
    for (size_t band = 0; band < bands.count; band++) {
        uint32_t top = (uint32_t)band * rows, bottom = top + rows;
        draw_band(&d, &bands, band, top, bottom < image->height ? bottom : image->height);
    }
    layers_free(d.layers);
    occlusion_free(d.occlusion);
    bands_free(&bands);
    projection_free(&d.projection);
}
