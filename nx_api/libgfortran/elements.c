/* elements.c - the number of an array's elements, for what depends on it in the cost of library calls
 * (nxcc/base/table.h), and the calls that have nothing but a price. */
#include "libgfortran.h"

long nx_elements(const struct descriptor *d)
{
    long n = 1;
    for (int i = 0; i < d->rank; i++) {
        int64_t extent = d->dimension[i].upper - d->dimension[i].lower + 1;
        n *= extent > 0 ? extent : 0;
    }
    return n;
}

#define PRICED(name)                                                                                         \
    void name(long n);                                                                                       \
    void name(long n)                                                                                        \
    {                                                                                                        \
        (void)n;                                                                                             \
    }
PRICED(nx_io_integers_out)
PRICED(nx_io_reals_out)
PRICED(nx_io_characters_out)
PRICED(nx_io_integers_in)
PRICED(nx_io_reals_in)
PRICED(nx_io_characters_in)
PRICED(nx_io_bytes)
