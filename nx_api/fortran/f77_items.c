/* f77_items.c - the cost of the items of READ and WRITE.
 *
 * GNU Fortran's library moves each item by a routine of the item's type. The library is not counted, so the
 * program is linked with -Wl,--wrap=ROUTINE for each routine: a call of ROUTINE reaches __wrap_ROUTINE, here,
 * which counts what an i860 would have had to do, and calls the library's __real_ROUTINE. The costs are those
 * of the calls of nx_io_*, empty functions, in machines/cpu/i860-calls.cfg.
 */
#include "../libgfortran/libgfortran.h"

/* n items that are read from text or written as text; characters: of one item. */
void nx_io_integers_out(long n), nx_io_reals_out(long n), nx_io_characters_out(long n);
void nx_io_integers_in(long n), nx_io_reals_in(long n), nx_io_characters_in(long n);
/* Bytes of an item that are copied. */
void nx_io_bytes(long n);

enum what { INTEGERS, REALS, CHARACTERS };

/* bytes: of one item. The calls are spelt out, because a call through a pointer has no cost. */
static void count_out(const struct statement *s, enum what what, long n, long bytes)
{
    if (!(s->flags & TEXT_FORMATS))
        nx_io_bytes(n * bytes);
    else if (what == INTEGERS)
        nx_io_integers_out(n);
    else if (what == REALS)
        nx_io_reals_out(n);
    else
        nx_io_characters_out(n);
}

static void count_in(const struct statement *s, enum what what, long n, long bytes)
{
    if (!(s->flags & TEXT_FORMATS))
        nx_io_bytes(n * bytes);
    else if (what == INTEGERS)
        nx_io_integers_in(n);
    else if (what == REALS)
        nx_io_reals_in(n);
    else
        nx_io_characters_in(n);
}

/* Scalars; a complex number is two. kind: an item's bytes, or a text's length. */
#define ITEM(routine, count, what, n, bytes)                                                                 \
    void __real__gfortran_transfer_##routine(struct statement *s, void *item, int kind);                     \
    void __wrap__gfortran_transfer_##routine(struct statement *s, void *item, int kind);                     \
    void __wrap__gfortran_transfer_##routine(struct statement *s, void *item, int kind)                      \
    {                                                                                                        \
        count(s, what, n, bytes);                                                                            \
        __real__gfortran_transfer_##routine(s, item, kind);                                                  \
    }
ITEM(integer, count_in, INTEGERS, 1, kind)
ITEM(integer_write, count_out, INTEGERS, 1, kind)
ITEM(logical, count_in, INTEGERS, 1, kind)
ITEM(logical_write, count_out, INTEGERS, 1, kind)
ITEM(real, count_in, REALS, 1, kind)
ITEM(real_write, count_out, REALS, 1, kind)
ITEM(complex, count_in, REALS, 2, kind)
ITEM(complex_write, count_out, REALS, 2, kind)
ITEM(character, count_in, CHARACTERS, kind, 1)
ITEM(character_write, count_out, CHARACTERS, kind, 1)

typedef void counting(const struct statement *s, enum what what, long n, long bytes);

static void count_array(counting *count, const struct statement *s, const struct descriptor *d, long length)
{
    long n = nx_elements(d);
    if (d->type == TYPE_CHARACTER)
        count(s, CHARACTERS, n * length, 1);
    else if (d->type == TYPE_COMPLEX)
        count(s, REALS, 2 * n, (long)d->element_bytes / 2);
    else
        count(s, d->type == TYPE_REAL ? REALS : INTEGERS, n, (long)d->element_bytes);
}

#define ARRAY(routine, count)                                                                                \
    void __real__gfortran_transfer_##routine(struct statement *s, struct descriptor *d, int kind,            \
                                             size_t length);                                                 \
    void __wrap__gfortran_transfer_##routine(struct statement *s, struct descriptor *d, int kind,            \
                                             size_t length);                                                 \
    void __wrap__gfortran_transfer_##routine(struct statement *s, struct descriptor *d, int kind,            \
                                             size_t length)                                                  \
    {                                                                                                        \
        count_array(count, s, d, (long)length);                                                              \
        __real__gfortran_transfer_##routine(s, d, kind, length);                                             \
    }
ARRAY(array, count_in)
ARRAY(array_write, count_out)
