/* occlusion.h - the ambient occlusion of opaque surfaces, the openness of each place to light from all
 * around: folds and holes are darker. Judged from what is seen, as "screen-space ambient occlusion" is
 * (after McGuire and others, The Alchemy screen-space ambient obscurance algorithm, 2011). */
#ifndef LAB_RENDER_OCCLUSION_H
#define LAB_RENDER_OCCLUSION_H
#include "lab/render/scene.h"

struct occlusion;

/* width, height: of the picture that the camera was made for, in pixels. */
struct occlusion *occlusion_make(const struct scene *scene, const struct camera *camera, uint32_t width,
                                 uint32_t height);
void occlusion_free(struct occlusion *o);

/* How open a place at pixel (x, y) is, 0 to 1, of an opaque surface at depth 1 / near. */
float occlusion_open(const struct occlusion *o, int32_t x, int32_t y, float near);
#endif
