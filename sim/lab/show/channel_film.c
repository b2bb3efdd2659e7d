/* channel_film.c - see channel_film.h. */
#include "lab/show/channel_film.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <webp/encode.h>
#include <webp/mux.h>
#include "files/atomic_file.h"
#include "kernel/xalloc.h"
#include "lab/draw/axes.h"
#include "lab/show/channel_shapes.h"

enum { FRAME_MS = 125, STRIP = 70 };

/* What each picture has below the map: the whole interval with the mean use of all channels, and where we
 * are. */
static void draw_strip(const struct channel_map *m, const struct canvas *c, struct plot p, uint32_t now)
{
    const struct time_bins *b = &m->use.bins;
    double *means = xcalloc(b->count, sizeof *means), most = 0, width = p.w / b->count;
    for (uint32_t i = 0; i < b->count; i++) {
        for (uint32_t channel = 0; channel < m->use.channels; channel++)
            means[i] += channel_use_share(&m->use, i, channel);
        most = fmax(most, means[i]);
    }
    for (uint32_t i = 0; most > 0 && i < b->count; i++) {
        double h = means[i] / most * p.h;
        canvas_fill(c, (struct plot){p.x + i * width, p.y + p.h - h, width, h},
                    i == now ? COLOUR(0xbb5566) : PALE);
    }
    canvas_line(c, p.x + (now + 0.5) * width, p.y, p.x + (now + 0.5) * width, p.y + p.h, 1, COLOUR(0xbb5566));
    canvas_frame(c, p);
    axes_time(c, p, b->from, b->to);
    free(means);
}

static char *frame_notes(const struct channel_map *m, uint32_t now)
{
    const struct time_bins *b = &m->use.bins;
    vtime resolution = (b->to - b->from) / 1000;
    char *from = axis_time_text(time_bins_edge(b, now), resolution),
         *to = axis_time_text(time_bins_edge(b, now + 1), resolution),
         *text = xasprintf("picture %u of %u: %s to %s; below: the use of all channels together", now + 1,
                           b->count, from, to);
    free(from);
    free(to);
    return text;
}

static void draw_frame(const struct channel_map *m, const struct canvas *c, uint32_t now)
{
    double below = HEAD_HEIGHT + channel_shapes_height(m->show) + 8;
    canvas_fill(c, (struct plot){0, 0, c->width, c->height}, COLOUR(0xffffff));
    show_head(m->show, c, "Use of channels", frame_notes(m, now));
    channel_shapes_draw(m, c, HEAD_HEIGHT, now);
    draw_strip(m, c, (struct plot){60, below, CANVAS_WIDTH - 60 - 30, STRIP - 40}, now);
}

/* Adds what is on the surface to the film. */
static bool add_frame(WebPAnimEncoder *film, cairo_surface_t *surface, uint32_t now)
{
    WebPConfig config;
    WebPPicture picture;
    if (!WebPConfigInit(&config) || !WebPConfigLosslessPreset(&config, 2) || !WebPPictureInit(&picture))
        return false;
    cairo_surface_flush(surface);
    picture.use_argb = 1;
    picture.width = cairo_image_surface_get_width(surface);
    picture.height = cairo_image_surface_get_height(surface);
    bool added = WebPPictureAlloc(&picture);
    const unsigned char *data = cairo_image_surface_get_data(surface);
    for (int y = 0; added && y < picture.height; y++) {
        const uint32_t *row =
            (const void *)(data + (size_t)y * (size_t)cairo_image_surface_get_stride(surface));
        for (int x = 0; x < picture.width; x++)
            picture.argb[y * picture.argb_stride + x] = row[x] | UINT32_C(0xff000000);
    }
    added = added && WebPAnimEncoderAdd(film, &picture, (int)now * FRAME_MS, &config);
    WebPPictureFree(&picture);
    return added;
}

static bool add_all(const struct show *s, WebPAnimEncoder *film, cairo_surface_t *surface, double height,
                    film_tell *tell)
{
    struct channel_map m = channel_map_make(s, time_bins_make(s->trace->from, s->trace->to, s->frames));
    struct canvas c = {cairo_create(surface), false, CANVAS_WIDTH, height};
    uint32_t count = m.use.bins.count;
    bool added = true;
    for (uint32_t i = 0; added && i < count; i++) {
        draw_frame(&m, &c, i);
        added = add_frame(film, surface, i);
        tell(i + 1, count);
    }
    added = added && WebPAnimEncoderAdd(film, NULL, (int)count * FRAME_MS, NULL);
    cairo_destroy(c.cr);
    channel_map_free(&m);
    return added;
}

static double film_height(const struct show *s)
{
    return ceil(HEAD_HEIGHT + channel_shapes_height(s) + 8 + STRIP + 10);
}

/* Puts the film together; false if libwebp fails, which is for want of memory. */
static bool make_film(const struct show *s, WebPData *data, film_tell *tell)
{
    double height = film_height(s);
    WebPAnimEncoderOptions options;
    if (!WebPAnimEncoderOptionsInit(&options))
        return false;
    WebPAnimEncoder *film = WebPAnimEncoderNew(CANVAS_WIDTH, (int)height, &options);
    if (!film)
        return false;
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, CANVAS_WIDTH, (int)height);
    bool made = add_all(s, film, surface, height, tell) && WebPAnimEncoderAssemble(film, data);
    cairo_surface_destroy(surface);
    WebPAnimEncoderDelete(film);
    return made;
}

bool channel_film_write(const struct show *s, const char *path, film_tell *tell, char **error)
{
    struct atomic_file f;
    WebPData data;
    WebPDataInit(&data);
    if (film_height(s) > WEBP_MAX_DIMENSION) {
        *error = xasprintf("%s cannot be made: its pictures would be %.0f pixels high, and have room for %d: "
                           "show fewer nodes",
                           path, film_height(s), WEBP_MAX_DIMENSION);
        return false;
    }
    if (!atomic_file_begin(&f, path, error))
        return false;
    if (!make_film(s, &data, tell)) {
        WebPDataClear(&data);
        atomic_file_drop(&f);
        *error = xasprintf("%s cannot be made: libwebp failed; try fewer pictures (--frames)", path);
        return false;
    }
    bool written = fwrite(data.bytes, 1, data.size, f.out) == data.size;
    int why = errno;
    WebPDataClear(&data);
    if (written)
        return atomic_file_end(&f, error);
    atomic_file_drop(&f);
    *error = xasprintf("%s cannot be written: %s", path, strerror(why));
    return false;
}
