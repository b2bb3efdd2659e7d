/* shade.h - the light that comes from one sample of a surface. */
#ifndef LAB_RENDER_SHADE_H
#define LAB_RENDER_SHADE_H
#include "lab/render/projection.h"

/* What is seen at a sample: a surface's place and normal there, in the camera's axes (right, up, back). */
struct shade_point {
    size_t surface;
    float colour[3];
    float normal[3]; /* of length 1, towards the viewer */
    float facing;    /* cosine of the angle between normal and the way to the viewer, more than 0 */
    float view[3];   /* the way to the viewer, of length 1 */
};

/* What is at sample (x, y) of a triangle, which covers the sample. samples: in a row of a pixel. */
struct shade_point shade_point(const struct projection *p, uint32_t triangle, int32_t x, int32_t y,
                               unsigned samples);

/* The light from there to the viewer: three lights that stay with the camera, and light from the sky and the
 * ground, of which `open` (0 to 1) arrives. */
void shade_light(const struct shade_point *at, float open, float light[3]);

/* How much of the light behind is held back: seen at an angle, the way through a thin layer is longer, and
 * holds back more. */
float shade_opacity(const struct shade_point *at, float opacity);
#endif
