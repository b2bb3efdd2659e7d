/* observer.h - what happens to a node, announced to those who observe it. sim/os does not know who listens: a
 * subscriber lies in a folder of its own, and begins the state that it keeps of a node with a struct observer
 * (doc/house.md: To add a subscriber). An observer changes nothing that programs or times depend on. */
#ifndef OS_OBSERVER_H
#define OS_OBSERVER_H
#include <stddef.h>
#include "node/node.h"

struct due;
struct observer;
struct nxm_told;
struct nxm_library;

/* Messages that a call sends, linked by next (first NULL: none). The send s, if any, reports when they have
 * left. Among all that the node has sent, they have so many numbers from `order` on. */
struct observed_send {
    const void *buf;
    size_t bytes;
    struct message *first;
    const struct send *s;
    uint64_t order, count;
};

/* What a kind of observers wants to be told; NULL: does not matter to it. */
struct announcements {
    bool in_order; /* the node's calls are not deferred, so that all is told in the total order */
    /* The node has been without a program up to time t. The program, or the node's part of the run, ends at
     * t: the observer may remove itself. */
    void (*no_program)(struct observer *o, struct node *n, vtime t);
    void (*ends)(struct observer *o, struct node *n, vtime t);
    /* The program has come to the call n->call.name; leaves it, or begins, and computes from now on. */
    void (*call_begins)(struct observer *o, struct node *n);
    void (*call_ends)(struct observer *o, struct node *n);
    /* No handler runs any more before the call does what it is for. */
    void (*call_acts)(struct observer *o, struct node *n);
    /* The call waits for a message to leave, or to come from a node (-1: from any); has waited, while the
     * system was busy for a part of the time. */
    void (*awaits)(struct observer *o, struct node *n, bool sends, long from);
    void (*waited)(struct observer *o, struct node *n, vtime begin, vtime end, vtime busy);
    /* The call sends messages; the program gives back the id of an isend. */
    void (*sends)(struct observer *o, struct node *n, const struct observed_send *what);
    void (*sent)(struct observer *o, struct node *n, const struct send *s);
    /* The node gives messages, linked by next, to the protocol: they are sent at time t, and leave so much
     * later. */
    void (*hands_over)(struct observer *o, struct node *n, const struct message *first, vtime t, vtime late);
    /* Posts a receive, withdraws it, or has put its message r->m into the program's memory: for a call, or a
     * handler about to run. */
    void (*posts)(struct observer *o, struct node *n, struct receive *r);
    void (*withdraws)(struct observer *o, struct node *n, struct receive *r);
    void (*takes)(struct observer *o, struct node *n, struct receive *r);
    /* Posts a receive of several types, of one node's messages, or with a handler; takes a message by one of
     * several types, of any node's messages, or with a handler. (Whoever hears these need not hear of each
     * receive of a program that has none of these.) */
    void (*posts_special)(struct observer *o, struct node *n, const struct receive *r);
    void (*takes_special)(struct observer *o, struct node *n, const struct receive *r);
    /* The message is thrown away at time t: by flushmsg, or because its type is a forced one and no receive
     * is posted. */
    void (*loses)(struct observer *o, struct node *n, const struct message *m, bool flushed, vtime t);
    /* The call that has just begun is deferred (deferred.h), or the one that the program was in already. */
    void (*deferred)(struct observer *o, struct node *n);
    void (*deferred_again)(struct observer *o, struct node *n);
    /* The first deferred call is committed at time t; its caller resumes at t, takes the last message, if
     * any, at takes_last and is done at `done`; the call is about to leave the deferred ones. All deferred
     * calls are about to be undone, for good. */
    void (*committed)(struct observer *o, struct node *n, vtime t);
    void (*resumed)(struct observer *o, struct node *n, vtime t, vtime takes_last, vtime done);
    void (*popped)(struct observer *o, struct node *n);
    void (*rolled_back)(struct observer *o, struct node *n);
    /* The envelope of a message comes at time t; a receive is given the message. */
    void (*envelope)(struct observer *o, struct node *n, const struct message *m, vtime t);
    void (*gives)(struct observer *o, struct node *n, const struct receive *r, const struct message *m);
    /* The node's receives are about to go: its program is gone. */
    void (*abandons)(struct observer *o, struct node *n);
    /* A message has come to the node, whoever receives it. */
    void (*arrives)(struct observer *o, struct node *n, const struct message *m);
    /* The call asks and does not wait, and has found no message that select selects. NULL: it asks for
     * nothing. */
    void (*finds_nothing)(struct observer *o, struct node *n, const struct selector *select);
    /* A handler becomes due at time t, which is so much later than usual. */
    void (*handler_due)(struct observer *o, struct node *n, vtime t, vtime late);
    /* A handler begins, before it takes its message; ends. */
    void (*handler_begins)(struct observer *o, struct node *n, const struct due *d);
    void (*handler_ends)(struct observer *o, struct node *n);
    /* The handler that has just ended has run instead of the program, which did not wait. */
    void (*interrupted)(struct observer *o, struct node *n, vtime begun, vtime ended);
    /* Handlers are masked, or let run. */
    void (*masks)(struct observer *o, struct node *n, bool masked);
    /* A call on a file reads the program's memory, or writes it. The heap gives out memory; the program gives
     * it back (these two may be told on another thread than the coordinator's). */
    void (*moves)(struct observer *o, struct node *n, bool write, const void *at, size_t bytes);
    void (*allocated)(struct observer *o, struct node *n, const void *at, size_t bytes);
    void (*freed)(struct observer *o, struct node *n, const void *at, size_t bytes);
    /* So much more time, modulo 2^64, is charged as the system's and as waiting: because of the call that the
     * program is in, or because the system interrupts it while it computes. */
    void (*charged)(struct observer *o, struct node *n, vtime system, vtime idle, bool computes);
    /* What is charged from now on belongs to the i-th deferred call; to the call that the program is in. */
    void (*charges_deferred)(struct observer *o, struct node *n, uint32_t i);
    void (*charges_program)(struct observer *o, struct node *n);
    /* The program calls MPI's library, which is a part of it; its call has ended (mpi_api/core/library.h).
     * Told on any thread. */
    void (*library_begins)(struct observer *o, struct node *n, const struct nxm_told *c,
                           const struct nxm_library *l);
    void (*library_ends)(struct observer *o, struct node *n, const struct nxm_told *c,
                         const struct nxm_library *l);
    /* The system works for t until `end` because of a message. */
    void (*system)(struct observer *o, struct node *n, enum node_task task, vtime end, vtime t);
};

/* One who observes one node; the first member of what the subscriber keeps of the node. */
struct observer {
    const struct announcements *hears;
    struct observer *next;
};

/* o hears of n from now on, after those who hear already; wants to be told other things; hears no more. */
void observer_add(struct node *n, struct observer *o);
void observer_wants(struct node *n, struct observer *o, const struct announcements *hears);
void observer_remove(struct node *n, struct observer *o);
/* n's observer of a kind; NULL: none. */
static inline struct observer *observer_of(const struct node *n, const struct announcements *hears)
{
    struct observer *o = n->observers;
    while (o && o->hears != hears)
        o = o->next;
    return o;
}

/* Does anybody want to be told that? The bit in heard. */
#define ANNOUNCEMENT(what) (UINT64_C(1) << offsetof(struct announcements, what) / sizeof(void (*)(void)))
#define IS_HEARD(n, what) __builtin_expect(((n)->heard & ANNOUNCEMENT(what)) != 0, 0)

/* Tells all observers of n. Where nobody wants to be told, one branch is all it costs. */
#define ANNOUNCE(n, what, ...)                                                                               \
    do {                                                                                                     \
        if (IS_HEARD(n, what))                                                                               \
            for (struct observer *o_ = (n)->observers, *next_; o_; o_ = next_) {                             \
                next_ = o_->next;                                                                            \
                if (o_->hears->what)                                                                         \
                    o_->hears->what(o_, (n), ##__VA_ARGS__);                                                 \
            }                                                                                                \
    } while (0)
#endif
