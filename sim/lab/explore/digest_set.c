/* digest_set.c - see digest_set.h. */
#include "lab/explore/digest_set.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

static bool is_free(struct digest d)
{
    return !d.high && !d.low;
}

/* Where d is, or would be. */
static struct digest *place_of(const struct digest_set *s, struct digest d)
{
    size_t at = d.low & (s->size - 1);
    while (!is_free(s->slot[at]) && !digest_equal(s->slot[at], d))
        at = (at + 1) & (s->size - 1);
    return &s->slot[at];
}

bool digest_set_has(const struct digest_set *s, struct digest d)
{
    return s->size && !is_free(*place_of(s, d));
}

static void grow(struct digest_set *s)
{
    struct digest_set larger = {.size = s->size ? 2 * s->size : 64, .count = s->count};
    larger.slot = xcalloc(larger.size, sizeof *larger.slot);
    for (size_t i = 0; i < s->size; i++)
        if (!is_free(s->slot[i]))
            *place_of(&larger, s->slot[i]) = s->slot[i];
    free(s->slot);
    *s = larger;
}

bool digest_set_add(struct digest_set *s, struct digest d)
{
    if (digest_set_has(s, d))
        return false;
    if (2 * (s->count + 1) > s->size)
        grow(s);
    *place_of(s, d) = d;
    s->count++;
    return true;
}

void digest_set_free(struct digest_set *s)
{
    free(s->slot);
    *s = (struct digest_set){0};
}
