/* page_surface.h - a surface as columns of numbers: see data_columns.h. */
#ifndef LAB_PAGE_PAGE_SURFACE_H
#define LAB_PAGE_PAGE_SURFACE_H
#include "lab/page/data_blob.h"
#include "lab/render/mesh.h"

void page_surface_write(const struct mesh *m, struct data_blob *b);
#endif
