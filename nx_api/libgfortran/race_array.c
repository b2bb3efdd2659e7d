/* race_array.c - tells the simulator of the elements of a Fortran array that a library call reads or writes:
 * for programs built with --races (nxcc/runtime/race_runtime.h). */
#include "libgfortran.h"
#include "../contract/races.h"
#include "../nxcc/runtime/race_runtime.h"

/* The address of the element where all indices but the first have the values of a count to `row`. */
static const char *row_of(const struct descriptor *d, int64_t row)
{
    int64_t elements = 0;
    for (int i = 1; i < d->rank; i++) {
        int64_t extent = d->dimension[i].upper - d->dimension[i].lower + 1;
        elements += row % extent * d->dimension[i].stride;
        row /= extent;
    }
    return (const char *)d->first + elements * d->span;
}

static void tell_row(const struct descriptor *d, const char *row, const struct nxc_race_site *site)
{
    int64_t extent = d->rank ? d->dimension[0].upper - d->dimension[0].lower + 1 : 1;
    int64_t step = d->rank ? d->dimension[0].stride * d->span : d->span;
    if (step == (int64_t)d->element_bytes) {
        nxc_race_range(row, (size_t)(extent * step), site);
        return;
    }
    for (int64_t i = 0; i < extent; i++)
        nxc_race_range(row + i * step, d->element_bytes, site);
}

void nx_race_array(const void *descriptor, const struct nxc_race_site *site)
{
    const struct descriptor *d = descriptor;
    int64_t elements = nx_elements(d);
    int64_t extent = d->rank ? d->dimension[0].upper - d->dimension[0].lower + 1 : 1;
    for (int64_t row = 0; elements > 0 && row < elements / extent; row++)
        tell_row(d, row_of(d, row), site);
}
