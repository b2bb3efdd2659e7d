/* livelock.h - signs that a program lives and comes no further: counts of its polls that find nothing, and of
 * the time that it stands still for handlers that follow one another. Reports are made of them
 * (machine/standstill.h).
 *
 * A poll is a call that asks and does not wait: iprobe, msgdone of a receive, flick. Polls of one call, from
 * one place of the program, for one kind of message make an entry. It counts the polls in a row that found
 * nothing. A message that the poll asks for ends the row when it comes to the node, whoever receives it; for
 * flick, which asks for nothing, any message or handler does.
 *
 * A siege is a time in which handlers took at least half of a program's time while it did not wait. It begins
 * with a handler. The next handler belongs to it, too, unless the program has had more than half of the time
 * by then.
 *
 * Counts are taken at committed moments only, so that they are the same on all engines. */
#ifndef OS_LIVELOCK_H
#define OS_LIVELOCK_H
#include "node/node.h"

/* An entry that finds no room takes that of the shortest row. */
enum { LIVELOCK_POLLS = 8, LIVELOCK_HANDLERS = 8, LIVELOCK_PLACES = 3 };

struct livelock_poll {
    const char *call; /* NULL: the entry is free */
    bool asks;        /* for a message that `select` selects */
    struct selector select;
    uintptr_t places[LIVELOCK_PLACES]; /* return addresses in the program, of the first poll; or 0 */
    uint64_t count;
    vtime since, spent; /* when the first of the row was made; the system time of all */
};

struct livelock_handler {
    mailbox_handler *handler;
    bool sends; /* of hsend; otherwise type is the typesel of hrecv */
    int64_t type;
    uint64_t count;
    vtime time;
};

struct livelock_siege {
    vtime since, until; /* until the last handler's end */
    vtime stood;        /* of that time the handlers took so much */
    uint64_t handlers;
    struct livelock_handler by[LIVELOCK_HANDLERS]; /* the first few kinds */
    uint32_t kinds;
};

struct livelock {
    struct livelock_poll polls[LIVELOCK_POLLS];
    struct livelock_poll *latest;
    uint32_t rows; /* entries in use */
    struct livelock_siege siege,
        worst; /* the present one; of the others, the one of the most handlers' time */
};

/* The call that the program is in, and which was made at `place`, has taken `spent`, and found nothing.
 * select: what it asked for; NULL: nothing. Begins the call a row? Then the entry's places are returned, for
 * the caller to fill in; else NULL. */
uintptr_t *livelock_found_nothing(struct node *n, const struct selector *select, uintptr_t place,
                                  vtime spent);
/* For nodes that have entries: see below. */
void livelock_end_rows(struct node *n, const struct message *m);
/* A message has come to the node; NULL: a handler has run. */
static inline void livelock_progress(struct node *n, const struct message *m)
{
    if (n->livelock && n->livelock->rows)
        livelock_end_rows(n, m);
}
/* A handler has interrupted the program from `begun` to `ended`. */
void livelock_interrupted(struct node *n, const struct livelock_handler *h, vtime begun, vtime ended);
void livelock_free(struct node *n);

#endif
