/* image_write.c - see image_write.h. */
#include "lab/render/image_write.h"
#include <png.h>
#include <stdlib.h>
#include <webp/encode.h>
#include <webp/mux.h>
#include "kernel/xalloc.h"

bool image_write_png(const struct image *image, FILE *out, char **error)
{
    png_image png = {.version = PNG_IMAGE_VERSION,
                     .width = image->width,
                     .height = image->height,
                     .format = PNG_FORMAT_RGBA};
    if (png_image_write_to_stdio(&png, out, 0, image->rgba, 0, NULL))
        return true;
    *error = xasprintf("PNG: %s", png.message);
    return false;
}

struct film {
    WebPAnimEncoder *encoder;
    WebPConfig config;
    int time_ms;
};

struct film *film_new(uint32_t width, uint32_t height)
{
    struct film *film = xcalloc(1, sizeof *film);
    WebPAnimEncoderOptions options;
    WebPAnimEncoderOptionsInit(&options);
    film->encoder = xchecked(WebPAnimEncoderNew((int)width, (int)height, &options));
    WebPConfigInit(&film->config);
    film->config.quality = 88;
    film->config.method = 3;
    return film;
}

bool film_add(struct film *film, const struct image *image, int milliseconds, char **error)
{
    WebPPicture picture;
    WebPPictureInit(&picture);
    picture.use_argb = 1;
    picture.width = (int)image->width;
    picture.height = (int)image->height;
    bool ok = WebPPictureImportRGBA(&picture, image->rgba, 4 * (int)image->width) &&
              WebPAnimEncoderAdd(film->encoder, &picture, film->time_ms, &film->config);
    if (!ok)
        *error = xasprintf("WebP: %s", WebPAnimEncoderGetError(film->encoder));
    film->time_ms += milliseconds;
    WebPPictureFree(&picture);
    return ok;
}

bool film_write(struct film *film, FILE *out, char **error)
{
    WebPData data;
    WebPDataInit(&data);
    bool ok = WebPAnimEncoderAdd(film->encoder, NULL, film->time_ms, NULL) &&
              WebPAnimEncoderAssemble(film->encoder, &data);
    if (!ok)
        *error = xasprintf("WebP: %s", WebPAnimEncoderGetError(film->encoder));
    if (ok)
        fwrite(data.bytes, 1, data.size, out);
    WebPDataClear(&data);
    return ok;
}

void film_free(struct film *film)
{
    WebPAnimEncoderDelete(film->encoder);
    free(film);
}

bool image_write_webp(const struct image *image, FILE *out, char **error)
{
    struct film *film = film_new(image->width, image->height);
    bool ok = film_add(film, image, 0, error) && film_write(film, out, error);
    film_free(film);
    return ok;
}
