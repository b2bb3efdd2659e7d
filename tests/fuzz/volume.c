/* volume.c - the model's input, a volume of pixels (app/volume.h). The first four bytes say what the
 * options do: pixels a row, rows, slices, and bits of a pixel. */
#include "volume.h"
#include <stdlib.h>
#include "fuzz.h"
#include "kernel/xalloc.h"

/* The volume masks handlers while it reads; there are none here. */
long masktrap(long state)
{
    (void)state;
    return 0;
}

static void read_slices(const struct options *o)
{
    struct volume v;
    char error[256];
    pixel *image = xcalloc((size_t)o->grid.pixels_x * (size_t)o->grid.pixels_y, sizeof *image);
    int order[] = {0, 1, o->grid.slices - 1, 0}, good = !volume_open(&v, o, error, sizeof error);
    for (size_t i = 0; good && i < sizeof order / sizeof *order; i++)
        good = !volume_read(&v, order[i], image, error, sizeof error);
    if (good != !volume_check(o, error, sizeof error) && !good)
        abort(); /* a volume of the right size can be read */
    volume_close(&v);
    free(image);
}

/* A file that cannot be opened leaves nothing behind: a leak ends the fuzzer. */
static void open_missing(const struct options *o)
{
    struct options missing = *o;
    char error[256];
    missing.volume = "/nowhere/volume";
    if (!volume_check(&missing, error, sizeof error))
        abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct options o = {0};
    if (size < 4)
        return 0;
    char *path = fuzz_path("volume");
    fuzz_file("volume", bytes + 4, size - 4);
    grid_set(&o.grid, 2 + bytes[0] % 64, 2 + bytes[1] % 64, 2 + bytes[2] % 64, 4, 1, 1.0);
    o.bits = bytes[3] & 1 ? 16 : 8;
    o.volume = path;
    read_slices(&o);
    open_missing(&o);
    free(path);
    return 0;
}
