/* race_places.h - the places of a program from which memory was accessed: each with its stack, once.
 *
 * A place is a site of the program (nx_api/contract/races.h), or a call of NX that moves data; the calls
 * under way there; and, for a handler, the place where it was posted. Shadow cells refer to places by
 * number. */
#ifndef RACES_RACE_PLACES_H
#define RACES_RACE_PLACES_H
#include <stdint.h>
#include "node/node.h"
#include "races/race_shadow.h"

enum { RACE_DEEPEST = 12, RACE_MOST_PLACES = 1 << RACE_PLACE_BITS };

struct race_place {
    uint32_t site;    /* offset of the struct nxc_race_site from the program's start; 0: a call's */
    const char *call; /* of NX, if site is 0; its text lasts */
    uint32_t posted;  /* number of the place that posted the handler; 0: no handler's */
    uint32_t depth;
    uint32_t stack[RACE_DEEPEST]; /* offsets of return addresses, the innermost first */
    uint32_t next;                /* with the same hash */
};

struct race_places;
struct race_places *race_places_new(void);
void race_places_free(struct race_places *t);
/* The number, from 1 up, of the place where the program of n is: site is the access's, or NULL, and call the
 * call's. frame: of a function that the program has called. 0 when there are too many places. */
uint32_t race_places_here(struct race_places *t, const struct node *n, const void *site, const char *call,
                          uint32_t posted, const void *frame);
/* A handler's own receive or send: the place that posted the handler, with its stack. */
uint32_t race_places_of_handler(struct race_places *t, const char *call, uint32_t posted);
/* A place by its number; number 0 has neither site nor stack. */
const struct race_place *race_places_at(const struct race_places *t, uint32_t number);
uint32_t race_places_count(const struct race_places *t);
#endif
