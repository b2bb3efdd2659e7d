/* race_flights.h - a node's buffers under way: of receives that are posted and sends that are not over, as
 * the program sees them: a buffer is under way until msgwait, msgdone or a handler has told its end,
 * whenever the bytes come or go.
 *
 * Most accesses concern no buffer. They are told by a gap, the widest stretch of memory around the last
 * access in which no buffer under way lies. */
#ifndef RACES_RACE_FLIGHTS_H
#define RACES_RACE_FLIGHTS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "races/race_clock.h"

struct race_flight {
    const void *key; /* the struct receive or struct send */
    uintptr_t begin, end;
    bool receives;         /* the buffer must not be read either */
    bool by_handler;       /* a handler has begun it */
    uint32_t place;        /* where it began */
    const char *call;      /* "irecv" */
    int request;           /* of MPI: the handle; 0: of NX */
    uint64_t began;        /* virtual time, ps */
    struct race_known now; /* what the strand that began it was, and knew of the other */
    struct race_clock *heard;
};

struct race_flights {
    struct race_flight *list;
    uint32_t count, room;
    uintptr_t gap_begin, gap_end; /* empty: not known */
};

void race_flights_end(struct race_flights *f);
/* *flight is copied, and `heard` is the list's from now on. */
void race_flights_add(struct race_flights *f, const struct race_flight *flight);
/* Takes out the flight of a key into *flight, whose `heard` is the caller's. False: there is none. */
bool race_flights_remove(struct race_flights *f, const void *key, struct race_flight *flight);
/* Keeps those of which `lives` says so. */
void race_flights_keep(struct race_flights *f, bool (*lives)(const void *ctx, const struct race_flight *),
                       const void *ctx);
/* The first whose buffer has any byte of [begin, end), from *from on; NULL: none. write: also sends. Sets
 * *from behind it. */
const struct race_flight *race_flights_next(const struct race_flights *f, uintptr_t begin, uintptr_t end,
                                            bool write, uint32_t *from);
/* Finds the gap around [begin, end), if no buffer has a byte of it. */
void race_flights_find_gap(struct race_flights *f, uintptr_t begin, uintptr_t end);
/* Does no buffer under way have any byte of [begin, end)? Quick; false if it is not known. */
static inline bool race_flights_miss(const struct race_flights *f, uintptr_t begin, uintptr_t end)
{
    return begin >= f->gap_begin && end <= f->gap_end;
}
#endif
