/* picture_file.h - writes a picture as a PNG or SVG file, which appears complete or not at all. */
#ifndef LAB_DRAW_PICTURE_FILE_H
#define LAB_DRAW_PICTURE_FILE_H
#include "lab/draw/canvas.h"

enum picture_kind { PICTURE_UNKNOWN, PICTURE_PNG, PICTURE_SVG, PICTURE_WEBP };
/* By the end of the name: .png, .svg, .webp. */
enum picture_kind picture_kind_of(const char *path);

/* Draws on a canvas of that height. */
typedef void picture_draw(void *ctx, const struct canvas *c);
/* False with *error, malloc'd, which names the file. kind: PNG or SVG. */
bool picture_write(const char *path, enum picture_kind kind, double height, picture_draw *draw, void *ctx,
                   char **error);
#endif
