/* unreached.c - the gray levels of the whole volume, beside isovalues that have no surface; see unreached.h.
 */
#include <stdio.h>
#include <stdlib.h>
#include "fail.h"
#include "unreached.h"
#include "volume.h"

struct levels {
    int lowest, highest;
};

static int are_all_found(const struct options *o, const double *polygons)
{
    int i;

    for (i = 0; i < o->iso.n; i++)
        if (polygons[i] == 0)
            return 0;
    return 1;
}

static void look_at_slice(struct levels *l, const pixel *image, long pixels)
{
    for (; pixels > 0; pixels--, image++) {
        if (*image < l->lowest)
            l->lowest = *image;
        if (*image > l->highest)
            l->highest = *image;
    }
}

/* Answers -1 if there is no memory for a slice, or the volume cannot be read again. */
static int find_levels(const struct options *o, struct levels *l)
{
    long pixels = (long)o->grid.pixels_x * o->grid.pixels_y;
    pixel *image = allocate_if_room(pixels * sizeof *image);
    struct volume v;
    char error[256];
    int k, bad;

    l->lowest = 65535;
    l->highest = 0;
    if (!image)
        return -1;
    bad = volume_open(&v, o, error, sizeof error);
    for (k = 0; k < o->grid.slices && !bad; k++) {
        bad = volume_read(&v, k, image, error, sizeof error);
        look_at_slice(l, image, pixels);
    }
    volume_close(&v);
    free(image);
    return bad;
}

static void say(const struct options *o, int surface, const struct levels *l)
{
    double isovalue = o->iso.value[surface];

    fprintf(stderr, "model: surface %d has no polygons: ", surface);
    if (!l)
        fprintf(stderr, "no grid point, or all of them, reach isovalue %.10g\n", o->asked[surface]);
    else if (isovalue > l->highest)
        fprintf(stderr, "no voxel is above isovalue %.10g; gray levels are %d to %d\n", o->asked[surface],
                l->lowest, l->highest);
    else if (isovalue < l->lowest)
        fprintf(stderr, "no voxel is below isovalue %.10g; gray levels are %d to %d\n", o->asked[surface],
                l->lowest, l->highest);
    else
        fprintf(stderr,
                "voxels lie on both sides of isovalue %.10g, but all grid points on one; try -grid 1\n",
                o->asked[surface]);
}

void unreached_say(const struct options *o, const double *polygons)
{
    struct levels l;
    int i, known;

    if (are_all_found(o, polygons))
        return;
    known = find_levels(o, &l) == 0;
    for (i = 0; i < o->iso.n; i++)
        if (polygons[i] == 0)
            say(o, i, known ? &l : NULL);
}
