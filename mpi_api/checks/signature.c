/* signature.c - see signature.h. */
#include "mpi_api/checks/signature.h"
#include <stdio.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

enum { MOST_RUNS = 1000 }; /* of a datatype: signatures of longer ones are not known */

void signature_free(struct signature *s)
{
    free(s->list);
    *s = (struct signature){0};
}

/* --- of a datatype --- */

static bool same_kind(const struct signature_run *a, const struct signature_run *b)
{
    return a->class == b->class && a->bytes == b->bytes;
}

/* A list of one run is there once. */
static void fold(struct signature *s)
{
    if (s->count == 1)
        s->list->numbers *= s->repeats, s->repeats = 1;
}

static void forget(struct signature *s)
{
    *s = (struct signature){.bytes = s->bytes, .list = s->list};
}

/* Puts numbers at the end of a list that is there once. False: there are too many. */
static bool append_run(struct signature *s, struct signature_run r)
{
    struct signature_run *last = s->count ? &s->list[s->count - 1] : NULL;
    if (last && same_kind(last, &r)) {
        last->numbers += r.numbers;
        return true;
    }
    if (s->count == MOST_RUNS)
        return false;
    s->list = xreallocarray(s->list, (size_t)s->count + 1, sizeof *s->list);
    s->list[s->count++] = r;
    return true;
}

static bool append(struct signature *s, const struct signature *part)
{
    for (size_t i = 0; i < part->repeats; i++)
        for (int k = 0; k < part->count; k++)
            if (!append_run(s, part->list[k]))
                return false;
    return part->count > 0 || !part->bytes;
}

/* Numbers of a byte are characters, whatever their signs. */
static struct signature_run run_of(uintptr_t type, const struct basic *b)
{
    bool text = b->bytes == 1 && b->class != LOGICAL && type != (uintptr_t)MPI_BYTE;
    return (struct signature_run){text ? WHOLE : b->class, b->bytes, 1};
}

static struct signature of_pair(uintptr_t type, const struct basic *b)
{
    struct signature s = {.repeats = 1};
    bool of_reals = type == (uintptr_t)MPI_2REAL || type == (uintptr_t)MPI_2DOUBLE_PRECISION;
    bool of_integers = type == (uintptr_t)MPI_2INT || type == (uintptr_t)MPI_2INTEGER ||
                       type == (uintptr_t)MPI_LONG_INT || type == (uintptr_t)MPI_SHORT_INT;
    append_run(&s, (struct signature_run){of_integers ? WHOLE : REAL, b->value, 1});
    append_run(&s, of_reals ? s.list[0] : (struct signature_run){WHOLE, sizeof(int), 1});
    for (int i = 0; i < s.count; i++)
        s.bytes += s.list[i].bytes * s.list[i].numbers;
    return s;
}

static struct signature of_basic(uintptr_t type, const struct basic *b)
{
    struct signature s = {.bytes = b->bytes, .repeats = 1};
    if (b->class == PAIR)
        return of_pair(type, b);
    if (type != (uintptr_t)MPI_PACKED && b->bytes)
        append_run(&s, run_of(type, b));
    return s;
}

/* Blocks of datatypes of their own, one after the other. */
static struct signature of_blocks(const struct nxm_library *l, const struct type *t)
{
    struct signature s = {.repeats = 1};
    bool known = true;
    for (int i = 0; i < t->types; i++) {
        struct signature part = signature_of(l, t->int_list[1 + i], (uintptr_t)t->type_list[i]);
        s.bytes += part.bytes;
        known = known && append(&s, &part);
        signature_free(&part);
    }
    if (!known)
        forget(&s);
    return s;
}

/* As many elements of one other datatype as it has room for. */
static struct signature of_one(const struct nxm_library *l, const struct type *t)
{
    struct signature s = signature_of(l, 1, (uintptr_t)t->type_list[0]);
    if (s.bytes) {
        s.repeats *= t->size / s.bytes;
        s.bytes = t->size;
        fold(&s);
    }
    return s;
}

struct signature signature_of(const struct nxm_library *l, int count, uintptr_t type)
{
    const struct basic *b = told_basic(l, type);
    const struct type *t = b ? NULL : told_type(l, type);
    struct signature s = {0};
    if ((!b && !t) || count <= 0)
        return s;
    if (b)
        s = of_basic(type, b);
    else if (t->combiner == MPI_COMBINER_STRUCT)
        s = of_blocks(l, t);
    else if (t->types == 1)
        s = of_one(l, t);
    s.repeats *= (size_t)count;
    s.bytes *= (size_t)count;
    fold(&s);
    return s;
}

/* --- of two calls --- */

/* A place in a signature. */
struct place {
    const struct signature *s;
    int run;
    size_t repeats, numbers; /* that are left */
};

static struct place begin(const struct signature *s)
{
    return (struct place){s, 0, s->repeats, s->count ? s->list->numbers : 0};
}

/* False: it is the end. */
static bool go_on(struct place *p, size_t numbers)
{
    p->numbers -= numbers;
    if (p->numbers)
        return true;
    if (++p->run == p->s->count)
        p->run = 0, p->repeats--;
    p->numbers = p->s->list[p->run].numbers;
    return p->repeats > 0;
}

/* A kind in words, as many as tell it from another. */
static char *kind_text(const struct signature_run *kind, const struct signature_run *other, size_t number)
{
    static const char *const classes[] = {
        [WHOLE] = "integers",          [NATURAL] = "unsigned integers", [REAL] = "reals",
        [COMPLEX] = "complex numbers", [LOGICAL] = "logicals",          [BITS] = "bytes",
    };
    char bytes[32] = "", at[32] = "";
    bool text = kind->class == WHOLE && kind->bytes == 1;
    if (kind->class == other->class)
        snprintf(bytes, sizeof bytes, " of %d bytes", kind->bytes);
    if (number > 1)
        snprintf(at, sizeof at, " as number %zu", number);
    return xasprintf("%s%s%s", text ? "characters" : classes[kind->class], text ? "" : bytes, at);
}

bool signatures_differ(const struct signature *a, const struct signature *b, char *kinds[2])
{
    struct place p = begin(a), q = begin(b);
    size_t number = 1;
    bool on = a->count && b->count && a->bytes && b->bytes;
    while (on) {
        const struct signature_run *x = &a->list[p.run], *y = &b->list[q.run];
        if (!same_kind(x, y)) {
            kinds[0] = kind_text(x, y, number), kinds[1] = kind_text(y, x, number);
            return true;
        }
        size_t both = p.numbers < q.numbers ? p.numbers : q.numbers;
        bool on_in_a = go_on(&p, both), on_in_b = go_on(&q, both);
        on = on_in_a && on_in_b;
        number += both;
    }
    return false;
}
