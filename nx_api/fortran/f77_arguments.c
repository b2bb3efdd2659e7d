/* f77_arguments.c - arguments that differ between Fortran and C: handlers, texts, arrays of integers. See
 * f77_entry.h. */
#include <stdlib.h>
#include <string.h>
#include "f77_entry.h"

/* --- handlers. A C handler does not learn which posting it runs for, so each Fortran procedure gets C
 * functions of its own. --- */

/* clang-format off */
#define TEN(X, d) X(d##0) X(d##1) X(d##2) X(d##3) X(d##4) X(d##5) X(d##6) X(d##7) X(d##8) X(d##9)
#define SLOTS(X) TEN(X, ) TEN(X, 1) TEN(X, 2) TEN(X, 3)
/* clang-format on */

enum { COUNT = 40 };

static procedure *slot[COUNT];

static void call(unsigned i, long type, long count, long node, long pid, long param)
{
    integer a = (integer)type, b = (integer)count, c = (integer)node, d = (integer)pid, e = (integer)param;
    slot[i](&a, &b, &c, &d, &e);
}

#define FUNCTIONS(i)                                                                                         \
    static void handler4_##i(long type, long count, long node, long pid)                                     \
    {                                                                                                        \
        call(i, type, count, node, pid, 0);                                                                  \
    }                                                                                                        \
    static void handler5_##i(long type, long count, long node, long pid, long param)                         \
    {                                                                                                        \
        call(i, type, count, node, pid, param);                                                              \
    }
SLOTS(FUNCTIONS)

#define NAMES(i) {handler4_##i, handler5_##i},
static const struct {
    handler4 *four;
    handler5 *five;
} functions[COUNT] = {SLOTS(NAMES)};

static unsigned slot_of(procedure *p, const char *call)
{
    for (unsigned i = 0; i < COUNT; i++) {
        if (!slot[i])
            slot[i] = p;
        if (slot[i] == p)
            return i;
    }
    nx_fail(call, ENOMEM); /* more than COUNT procedures */
}

handler4 *nx_fortran_handler(procedure *p, const char *call)
{
    return p ? functions[slot_of(p, call)].four : NULL;
}

handler5 *nx_fortran_xhandler(procedure *p, const char *call)
{
    return p ? functions[slot_of(p, call)].five : NULL;
}

/* --- texts and arrays --- */

char *nx_fortran_text(const char *s, size_t bytes, const char *call)
{
    while (bytes > 0 && s[bytes - 1] == ' ')
        bytes--;
    char *copy = malloc(bytes + 1);
    if (!copy)
        nx_fail(call, ENOMEM);
    memcpy(copy, s, bytes);
    copy[bytes] = '\0';
    return copy;
}

long *nx_fortran_longs(in *values, long count, const char *call)
{
    long *longs = malloc((size_t)(count > 0 ? count : 1) * sizeof *longs);
    if (!longs)
        nx_fail(call, ENOMEM);
    for (long i = 0; i < count; i++)
        longs[i] = values[i];
    return longs;
}

/* --- INFO(8) of irecvx: NX fills longs when the message is taken; the program's INTEGERs are filled when the
 * program waits for the id or asks for it. Till NX has filled them longs[0] is -1, which is no type: before
 * msgwait returns a handler may have called irecvx, and got the id that msgwait gives back. --- */

static struct pending {
    long id;
    integer *info;
    long *longs;
    struct pending *next;
} * pending;

/* The four reserved elements stay unchanged. */
void nx_fortran_info(integer *info, const long *longs)
{
    for (int i = 0; i < 4; i++)
        info[i] = (integer)longs[i];
}

void nx_fortran_info_at(long id, integer *info, long *longs)
{
    struct pending *p = malloc(sizeof *p);
    if (!p)
        nx_fail("irecvx", ENOMEM);
    *p = (struct pending){id, info, longs, pending};
    pending = p;
}

static void end(long id, bool fill, bool keep_longs)
{
    for (struct pending **link = &pending, *p; (p = *link);) {
        if (p->id != id || (fill && p->longs[0] == -1)) {
            link = &p->next;
            continue;
        }
        *link = p->next;
        if (fill)
            nx_fortran_info(p->info, p->longs);
        if (!keep_longs)
            free(p->longs);
        free(p);
    }
}

void nx_fortran_info_done(long id)
{
    end(id, true, false);
}

void nx_fortran_info_forget(long id, bool ignored)
{
    end(id, false, ignored);
}

void nx_fortran_info_merge(long first, long second, long merged)
{
    for (struct pending *p = pending; p; p = p->next)
        if (p->id == first || p->id == second)
            p->id = merged;
}
