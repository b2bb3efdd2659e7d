/* image_write.h - pictures as files: PNG (libpng), and WebP (libwebp), still or moving. Browsers play moving
 * WebP as they show any other picture. */
#ifndef LAB_RENDER_IMAGE_WRITE_H
#define LAB_RENDER_IMAGE_WRITE_H
#include <stdbool.h>
#include <stdio.h>
#include "lab/render/pixel_image.h"

/* Write to out. False with *error malloc'd. Whether all was written, out knows, too (ferror). */
bool image_write_png(const struct image *image, FILE *out, char **error);
bool image_write_webp(const struct image *image, FILE *out, char **error);

/* A film that repeats without end, of pictures of one size. */
struct film;
struct film *film_new(uint32_t width, uint32_t height);
/* Adds a picture, which is shown so many milliseconds. False with *error malloc'd. */
bool film_add(struct film *film, const struct image *image, int milliseconds, char **error);
/* Writes the film as WebP. False with *error malloc'd; whether all was written, out knows (ferror). */
bool film_write(struct film *film, FILE *out, char **error);
void film_free(struct film *film);
#endif
