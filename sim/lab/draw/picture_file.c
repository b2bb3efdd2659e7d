/* picture_file.c - see picture_file.h. */
#include "lab/draw/picture_file.h"
#include <cairo/cairo-svg.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "files/atomic_file.h"
#include "kernel/xalloc.h"

enum { MOST_PIXELS = 32767 }; /* of an image of libcairo's, each way */

enum picture_kind picture_kind_of(const char *path)
{
    const char *dot = strrchr(path, '.');
    if (!dot || strchr(dot, '/'))
        return PICTURE_UNKNOWN;
    return !strcasecmp(dot, ".png")    ? PICTURE_PNG
           : !strcasecmp(dot, ".svg")  ? PICTURE_SVG
           : !strcasecmp(dot, ".webp") ? PICTURE_WEBP
                                       : PICTURE_UNKNOWN;
}

struct sink {
    FILE *out;
    int why; /* errno of the first write that failed */
};

static cairo_status_t write_bytes(void *ctx, const unsigned char *data, unsigned length)
{
    struct sink *s = ctx;
    if (fwrite(data, 1, length, s->out) == length)
        return CAIRO_STATUS_SUCCESS;
    s->why = s->why ? s->why : errno;
    return CAIRO_STATUS_WRITE_ERROR;
}

static cairo_surface_t *surface_for(struct sink *out, enum picture_kind kind, double height)
{
    if (kind == PICTURE_SVG)
        return cairo_svg_surface_create_for_stream(write_bytes, out, CANVAS_WIDTH, height);
    return cairo_image_surface_create(CAIRO_FORMAT_RGB24, CANVAS_WIDTH * CANVAS_PIXELS,
                                      (int)height * CANVAS_PIXELS);
}

/* Draws and writes; what went wrong stays in the surface. */
static cairo_status_t draw_to(struct sink *out, enum picture_kind kind, double height, picture_draw *draw,
                              void *ctx)
{
    cairo_surface_t *surface = surface_for(out, kind, height);
    struct canvas c = {cairo_create(surface), kind == PICTURE_SVG, CANVAS_WIDTH, height};
    if (!c.vector)
        cairo_scale(c.cr, CANVAS_PIXELS, CANVAS_PIXELS);
    canvas_fill(&c, (struct plot){0, 0, CANVAS_WIDTH, height}, COLOUR(0xffffff));
    draw(ctx, &c);
    cairo_status_t status = cairo_status(c.cr);
    cairo_destroy(c.cr);
    if (!status && kind == PICTURE_PNG)
        status = cairo_surface_write_to_png_stream(surface, write_bytes, out);
    cairo_surface_finish(surface);
    if (!status)
        status = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    return status;
}

bool picture_write(const char *path, enum picture_kind kind, double height, picture_draw *draw, void *ctx,
                   char **error)
{
    struct atomic_file f;
    if (kind != PICTURE_SVG && ceil(height) * CANVAS_PIXELS > MOST_PIXELS) {
        *error =
            xasprintf("%s cannot be drawn: it would be %.0f pixels high, and has room for %d: show fewer "
                      "nodes, or write an .svg",
                      path, ceil(height) * CANVAS_PIXELS, MOST_PIXELS);
        return false;
    }
    if (!atomic_file_begin(&f, path, error))
        return false;
    struct sink sink = {.out = f.out};
    cairo_status_t status = draw_to(&sink, kind, ceil(height), draw, ctx);
    if (!status)
        return atomic_file_end(&f, error);
    atomic_file_drop(&f);
    *error = sink.why ? xasprintf("%s cannot be written: %s", path, strerror(sink.why))
                      : xasprintf("%s cannot be drawn: %s", path, cairo_status_to_string(status));
    return false;
}
