/* pixel_image.h - a picture as pixels. */
#ifndef LAB_RENDER_PIXEL_IMAGE_H
#define LAB_RENDER_PIXEL_IMAGE_H
#include <stdint.h>

struct image {
    uint32_t width, height;
    uint8_t *rgba; /* rows from the top; sRGB and opacity, which does not multiply the colours */
};

struct image image_new(uint32_t width, uint32_t height);
void image_free(struct image *image);
#endif
