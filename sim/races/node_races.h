/* node_races.h - the race checker of one node: what is known of its two strands, of its memory and of its
 * buffers. For the files of this folder, and for reports (sim/observe); race_check.h is for others.
 *
 * Two accesses to a byte race if one is a handler's and one the main program's, at least one writes, and
 * nothing orders them (happens-before: Lamport 1978; by epochs as in Flanagan & Freund, "FastTrack", PLDI
 * 2009). Where the handler came in this run orders nothing. Ordered are
 *
 *   - what the main program does; a handler's posting and its run; a message's sending and its receiving,
 *     by the main program or by the run of a handler (races/race_clock.h);
 *   - a handler's run and what the main program does when it has heard of it;
 *   - parts of the program that exclude each other, if data flows from one to the other: what the main
 *     program does while handlers are masked, and what handlers do. If one reads what the other has written,
 *     or writes what the other has read, all that came before the earlier access is ordered before the later
 *     one (as in Smaragdakis & al., "Sound Predictive Race Detection in Polynomial Time", POPL 2012; writing
 *     what the other has written orders nothing here);
 *   - in the same way, accesses to volatile objects of at most 8 bytes, and to what the main program waits
 *     for in a loop (NXC_RACE_SPIN).
 *
 * A write of a volatile object whose value was computed from a read of it (an update) is one step only if
 * handlers were masked from the read to the write. Otherwise a handler's write in between is lost. It could
 * come there if it came there in this run; or if it came later, and would come before the update if only its
 * time were another: if neither its posting, nor a message, nor its reading of another word that the main
 * program wrote after the update orders it. What the main program does up to the update is the same then.
 *
 * A handler's run cannot be interrupted by the main program: so it has one epoch. The main program begins a
 * new one when it goes on after anything that another strand may hear of, and after a handler ran. Handlers
 * of a node are taken to run in this run's order for those who hear of them; but what a handler itself has
 * heard of the main program is known for each run.
 *
 * What a handler's run puts back as it found it does not race: races/race_restored.h.
 *
 * When nothing is to be told. Before a handler is posted no access can race with one: whoever posts it has
 * made all these accesses before, and each run of a handler is ordered behind its posting. The same is so
 * again when no handler is posted or due, and the main program has heard of the last that ran: all that
 * handlers did is ordered before all that the program does from then on, up to its next hrecv or hsend. So
 * what the shadow holds then can never be a part of a race, and is forgotten. (Of messages it matters all
 * the same what a node has heard of other nodes; a node that has never posted a handler, and has heard of
 * none that did, can tell nobody anything, and its messages carry nothing.) While a buffer is under way,
 * accesses are told, too, but only compared with the buffers. */
#ifndef RACES_NODE_RACES_H
#define RACES_NODE_RACES_H
#include "net/protocol.h"
#include "node/node.h"
#include "nx_api/contract/races.h"
#include "os/observer.h"
#include "races/race_clock.h"
#include "races/race_findings.h"
#include "races/race_flights.h"
#include "races/race_places.h"
#include "races/race_restored.h"
#include "races/race_shadow.h"

struct races;

enum { RACE_MOMENTS = 256 };

/* An epoch: when it began; of a handler's run: the main program's epoch of which the run has heard. */
struct race_moment {
    uint64_t epoch;
    vtime at;
    uint64_t knows;
};

struct node_races {
    struct observer observer; /* first */
    struct observer library;  /* of MPI's calls: race_mpi.h */
    struct races *all;
    struct node_races *next;
    const struct node_image *file;
    uint32_t number; /* its component in clocks: the host's is 0 */
    char name[16];
    uint8_t *on;                     /* nxc_races.on of the program */
    uint32_t sites_begin, sites_end; /* offsets of its struct nxc_race_site */
    bool tracks;                     /* accesses are compared with each other, not only with buffers */
    bool gone;                       /* the node has no program any more: only its findings are left */
    vtime since;                     /* the program has computed since then */
    struct {
        uint64_t epoch;
        uint64_t knows;      /* the last handler's run that it has heard of */
        bool released;       /* another may have heard of the epoch: what comes is the next's */
        uint64_t part;       /* since this epoch handlers have not become unmasked */
        const void *updates; /* what it writes next gets a value computed from itself: NXC_RACE_UPDATE */
        struct race_clock *heard;
    } main;
    struct {
        uint64_t run; /* the number of the present one, or of the last */
        bool runs;
        uint64_t knows; /* the run: the main program's last epoch that it has heard of */
        uint64_t told;  /* and of which its posting and messages have told, and no data flow */
        struct race_reading {
            uint64_t epoch;
            uintptr_t object;
        } read[2]; /* and what it has read of it: the two latest epochs, of two objects */
        struct race_clock *heard;
        uint32_t posted;  /* the place that posted it */
        const char *call; /* "hrecv" */
        uintptr_t frame;  /* of the system, where it has interrupted the program */
    } handlers;
    const struct nxm_told *in_library; /* the call of MPI that the program is in; NULL: none */
    uintptr_t stack_low;               /* handlers have accessed no memory of the program's stack below */
    struct race_moment main_moments[RACE_MOMENTS], runs[RACE_MOMENTS]; /* by epoch, the last ones */
    uint64_t older_knows; /* the most that runs knew that are no longer in `runs` */
    struct race_shadow *shadow;
    struct race_places *places;
    struct race_flights flights;
    struct race_findings findings;
    struct race_restored restored; /* by the present run */
};

/* What a message carries: what its sender was, and had heard of. */
struct race_stamp {
    struct protocol_cargo cargo;
    struct races *all;
    struct race_stamp *next, **link; /* of all: those that are left when the run is over */
    uint32_t node;
    struct race_known known;
    struct race_clock *heard;
};

/* All nodes of a machine, and the stamps of messages. */
struct races {
    struct node_races *nodes; /* in the order of their making */
    struct node_races **last;
    struct race_stamp *stamps;
};

/* --- race_strands.c --- */

extern const struct announcements race_observer;

/* NULL: the node's program was built without --races. */
static inline struct node_races *races_of(const struct node *n)
{
    return (struct node_races *)observer_of(n, &race_observer);
}

/* A buffer is under way from now on: *f has its key, place, call, bounds and direction. */
void race_take_off(struct node *n, struct race_flight *f);
/* Accesses are told only while they matter. */
void race_set_on(struct node *n);

/* The main program's epoch for what it does now. */
uint64_t race_main_epoch(struct node_races *r);
/* The program on the strand that runs hears of a node's strands. */
void race_hear(struct node_races *r, uint32_t node, struct race_known known, const struct race_clock *heard);
/* Data flow: the main program hears of a handler's run; a handler, of an epoch of the main program, or of
 * what an earlier run knew. */
void race_main_hears_run(struct node_races *r, uint64_t run);
void race_handler_hears_main(struct node_races *r, uint64_t epoch);
void race_handler_hears_run(struct node_races *r, uint64_t run);
/* When an epoch of the main program, or a run, began; VT_NEVER: it is too long ago. */
vtime race_main_moment(const struct node_races *r, uint64_t epoch);
vtime race_run_moment(const struct node_races *r, uint64_t run);

/* --- race_access.c --- */

/* The place where the program is in a call, told by the frame of a function in the call. */
uint32_t race_place_in_call(struct node *n, const char *call, const void *frame);
/* A call, or the system on behalf of a handler, accesses memory from a place. */
void race_access_in_call(struct node *n, uintptr_t at, size_t bytes, bool write, uint32_t place);
/* A call is given a buffer: reports what is under way there. receives: the call writes to it. */
void race_buffer_in_call(struct node *n, uintptr_t at, size_t bytes, bool receives, uint32_t place);
#endif
