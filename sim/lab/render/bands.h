/* bands.h - the triangles of a picture, sorted into bands: so many rows of samples each. */
#ifndef LAB_RENDER_BANDS_H
#define LAB_RENDER_BANDS_H
#include "lab/render/projection.h"

struct bands {
    size_t count;
    size_t *first;      /* of each band, and the end */
    uint32_t *triangle; /* numbered through; in each band in rising order */
};

/* rows: of samples in a band; height: of the picture, in samples. Triangles that cover no row are left
 * out. */
struct bands bands_make(const struct projection *p, int32_t rows, int32_t height);
void bands_free(struct bands *b);
#endif
