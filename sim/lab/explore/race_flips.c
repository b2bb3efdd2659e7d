/* race_flips.c - see race_flips.h. */
#include "lab/explore/race_flips.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static bool is_in_handler(const json_t *access)
{
    const char *in = json_string_value(json_object_get(access, "in"));
    return in && !strcmp(in, "handler");
}

/* The time of an access; VT_NEVER: not known. */
static vtime time_of(const json_t *access)
{
    const json_t *at = json_object_get(access, "at_s");
    return json_is_number(at) ? (vtime)llround(json_number_value(at) * (double)VT_SECOND) : VT_NEVER;
}

/* The handler of the node that ran at the time: the last that had begun. NULL: none. */
static const struct rec_handler *handler_at(const struct recording *r, uint32_t node, vtime time)
{
    const struct rec_handler *found = NULL;
    for (const struct rec_handler *h = r->handlers; h < r->handlers + r->handler_count; h++)
        if (h->node == node && h->at <= time && (!found || h->at >= found->at))
            found = h;
    return found;
}

static void add_race(struct flips *all, const struct order *o, const struct delay_bounds *bounds,
                     uint32_t node, const json_t *in_handler, const json_t *in_program)
{
    vtime first = time_of(in_handler), second = time_of(in_program);
    const struct rec_handler *h = handler_at(o->recording, node, first);
    if (first != VT_NEVER && second != VT_NEVER && h && first < second)
        flips_add_wanted(all, o, bounds, &(struct wanted_interrupt){node, h->number, second});
}

/* The node of "node 3"; false for the host, whose handlers are not directed. */
static bool node_of(const json_t *race, uint32_t *node)
{
    const char *name = json_string_value(json_object_get(race, "first_on"));
    return name && sscanf(name, "node %" SCNu32, node) == 1;
}

void race_flips_add(struct flips *all, const struct order *o, const struct delay_bounds *bounds,
                    const json_t *races)
{
    size_t i;
    json_t *race;
    json_array_foreach(races, i, race)
    {
        const json_t *pair = json_object_get(race, "accesses");
        const json_t *one = json_array_get(pair, 0), *other = json_array_get(pair, 1);
        uint32_t node;
        if (!node_of(race, &node))
            continue;
        if (is_in_handler(one) && !is_in_handler(other))
            add_race(all, o, bounds, node, one, other);
        else if (is_in_handler(other) && !is_in_handler(one))
            add_race(all, o, bounds, node, other, one);
    }
}
