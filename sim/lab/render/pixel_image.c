/* pixel_image.c - see pixel_image.h. */
#include "lab/render/pixel_image.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

struct image image_new(uint32_t width, uint32_t height)
{
    return (struct image){width, height, xcalloc((size_t)width * height, 4)};
}

void image_free(struct image *image)
{
    free(image->rgba);
    *image = (struct image){0};
}
