/* volume.c - reads slices from a raw file, through zlib, which reads plain files as well; or generates
 * slices. */
#include <stdio.h>
#include <stdlib.h>
#include <zlib.h>
#include <nx.h>
#include "volume.h"

int volume_open(struct volume *v, const struct options *o, char *error, int size)
{
    v->o = o;
    v->file = NULL;
    v->next = 0;
    v->bytes = NULL;
    if (!o->volume)
        return 0;
    v->bytes = malloc((size_t)o->grid.pixels_x * o->bits / 8);
    v->file = gzopen(o->volume, "rb");
    if (v->file && v->bytes)
        return 0;
    volume_close(v);
    v->file = NULL;
    v->bytes = NULL;
    snprintf(error, size, "cannot open the volume %s", o->volume);
    return -1;
}

/* Handlers use the C library, too, so that a call of it must not be interrupted. */
static int read_row(struct volume *v, int bytes)
{
    long old = masktrap(1);
    int got = gzread(v->file, v->bytes, bytes);

    masktrap(old);
    return got == bytes ? 0 : -1;
}

/* The bytes of one slice. */
static long slice_bytes(const struct options *o)
{
    return (long)o->grid.pixels_x * o->grid.pixels_y * (o->bits / 8);
}

static int go_to(struct volume *v, int k)
{
    long slice = slice_bytes(v->o), old;
    int ok = 1;

    if (v->next != k) {
        old = masktrap(1);
        ok = gzseek(v->file, k * slice, 0) == k * slice;
        masktrap(old);
    }
    v->next = k + 1;
    return ok ? 0 : -1;
}

/* Counts the bytes, at most 2, from the last byte that the options expect: 1 if the file has the right
 * size. */
static int bytes_at_end(gzFile file, const struct options *o)
{
    z_off_t last = (z_off_t)slice_bytes(o) * o->grid.slices - 1;
    unsigned char byte[2];

    return gzseek(file, last, 0) == last ? gzread(file, byte, 2) : 0;
}

int volume_check(const struct options *o, char *error, int size)
{
    const struct grid *g = &o->grid;
    struct volume v;
    int got;

    if (!o->volume)
        return 0;
    if (volume_open(&v, o, error, size))
        return -1;
    got = bytes_at_end(v.file, o);
    volume_close(&v);
    if (got == 1)
        return 0;
    snprintf(error, size, "%s holds %s than %d x %d x %d pixels of %d bits", o->volume,
             got > 1 ? "more" : "less", g->pixels_x, g->pixels_y, g->slices, o->bits);
    return -1;
}

int volume_read(struct volume *v, int k, pixel *image, char *error, int size)
{
    const struct grid *g = &v->o->grid;
    int wide = v->o->bits / 8, x, y, bad;

    if (!v->file) {
        slice_sphere(g, k, image);
        return 0;
    }
    bad = go_to(v, k);
    for (y = 0; y < g->pixels_y && !bad; y++) {
        bad = read_row(v, g->pixels_x * wide);
        for (x = 0; x < g->pixels_x && !bad; x++)
            *image++ = (pixel)(wide == 1 ? v->bytes[x] : v->bytes[2 * x] | v->bytes[2 * x + 1] << 8);
    }
    if (bad)
        snprintf(error, size, "%s ends before slice %d of %d is complete (%d x %d pixels of %d bits)",
                 v->o->volume, k + 1, g->slices, g->pixels_x, g->pixels_y, v->o->bits);
    return bad;
}

void volume_close(struct volume *v)
{
    if (v->file)
        gzclose(v->file);
    free(v->bytes);
}
