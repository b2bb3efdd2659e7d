/* slices.c - reads slices and makes their C0 or C3 data, a few slices ahead of the work.
 *
 * C3 data of slice k take slices k-1 to k+1. A group reads one slice beyond its share at either end, if there
 * is one, so that the data do not depend on how slices are divided. C0 data do not need these boundary
 * slices. The slice above is read nevertheless, in the group's last layer: Table 3 of the paper has time for
 * reading it there.
 */
#include <stddef.h>
#include <stdlib.h>
#include "c3.h"
#include "fail.h"
#include "slices.h"
#include "volume.h"

#define KEPT 3

static struct {
    const struct options *o;
    struct volume volume;
    pixel *image[KEPT]; /* slice k is in place k % KEPT */
    double *data[KEPT];
    int next_image, next_data;
} window;

static int is_cubic(void)
{
    return window.o->grid.comps == C3_COMPS;
}

void slices_begin(const struct options *o, int first)
{
    const struct grid *g = &o->grid;
    char error[256];
    int i;

    window.o = o;
    for (i = 0; i < KEPT; i++) {
        window.data[i] = allocate(grid_slice_doubles(g) * sizeof(double));
        if (i == 0 || is_cubic())
            window.image[i] = allocate((size_t)g->pixels_x * g->pixels_y * sizeof(pixel));
        else
            window.image[i] = window.image[0];
    }
    window.next_data = first;
    window.next_image = is_cubic() && first > 0 ? first - 1 : first;
    if (volume_open(&window.volume, o, error, sizeof error))
        fail("%s", error);
}

static void read_image(void)
{
    char error[256];
    int k = window.next_image++;

    if (volume_read(&window.volume, k, window.image[k % KEPT], error, sizeof error))
        fail("%s", error);
}

static void make_data(void)
{
    const struct grid *g = &window.o->grid;
    int k = window.next_data++, last = g->slices - 1, ahead = is_cubic() && k < last ? k + 1 : k;
    const pixel *image = window.image[k % KEPT];

    while (window.next_image <= ahead)
        read_image();
    if (is_cubic())
        c3_slice(g, k > 0 ? window.image[(k - 1) % KEPT] : NULL, image,
                 k < last ? window.image[(k + 1) % KEPT] : NULL, window.data[k % KEPT]);
    else
        c0_slice(g, image, window.data[k % KEPT]);
}

void slices_prepare(int k)
{
    while (window.next_data <= k)
        make_data();
}

void slices_overlap(void)
{
    if (window.next_image == window.next_data && window.next_image < window.o->grid.slices)
        read_image();
}

struct layer slices_layer(int k)
{
    struct layer l;

    l.lower = window.data[k % KEPT];
    l.upper = window.data[(k + 1) % KEPT];
    l.number = k;
    l.row = 0;
    return l;
}

void slices_end(void)
{
    int i;

    for (i = 0; i < KEPT; i++) {
        free(window.data[i]);
        if (i == 0 || is_cubic())
            free(window.image[i]);
    }
    volume_close(&window.volume);
}
