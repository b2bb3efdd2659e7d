/* livelock.h - signs that a program lives and comes no further: counts of its polls that find nothing, and of
 * the time that it stands still for handlers that follow one another. An observer (os/observer.h) takes them
 * down; reports are made of them (machine/standstill.h).
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
 * Polls that are deferred, and never committed, are taken back: counts are the same on all engines. */
#ifndef NOTES_LIVELOCK_H
#define NOTES_LIVELOCK_H
#include "node/node.h"

/* An entry that finds no room takes that of the shortest row. */
enum { LIVELOCK_POLLS = 8, LIVELOCK_HANDLERS = 8, LIVELOCK_PLACES = 5 };

struct livelock_poll {
    const char *call; /* NULL: the entry is free */
    bool asks;        /* for a message that `select` selects */
    struct selector select;
    uintptr_t places[LIVELOCK_PLACES]; /* return addresses in the program, of the first poll; or 0 */
    uint64_t count;
    vtime since, latest; /* when the first of the row was made, and the latest */
    vtime spent;         /* what all of them took */
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

/* The node's program has been loaded; is gone. */
void livelock_begin(struct node *n);
void livelock_end(struct node *n);
/* NULL: no poll has found nothing, and no handler has interrupted the program. */
const struct livelock *livelock_of(const struct node *n);
#endif
