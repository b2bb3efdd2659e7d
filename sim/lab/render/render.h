/* render.h - draws a scene: the same scene gives the same pixels on any computer of one kind.
 *
 * Surfaces are smooth-shaded triangles with a z-buffer. Transparent ones are sorted at each sample, so that
 * any number may lie behind and within each other. Each pixel is the mean of SAMPLES x SAMPLES samples. */
#ifndef LAB_RENDER_RENDER_H
#define LAB_RENDER_RENDER_H
#include "lab/render/pixel_image.h"
#include "lab/render/scene.h"

enum { RENDER_SAMPLES = 3, RENDER_MOST_SIZE = 4096, RENDER_MOST_ZOOM = 100 };

/* Draws what the camera sees, which was made for a picture of the image's size; that is at most
 * RENDER_MOST_SIZE each way, and its zoom at most RENDER_MOST_ZOOM. */
void render(const struct scene *scene, const struct camera *camera, struct image *image);
#endif
