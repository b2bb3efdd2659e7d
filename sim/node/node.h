/* node.h - one simulated node: its memory and program image, its processor's clock, its mailbox and
 * interrupts.
 *
 * Its program, stack and heap lie in a region of address space (span.h), so that a call finds its node from the stack
 * pointer (node_self) and no state is shared or thread-local.
 *
 * What counts against the node's memory (machine file: memory_mb): the operating system, the program's image,
 * its stack, its heap up to the highest block in use, and unexpected messages in system buffers.
 *
 * Time. The program's own progress is counted in cost units by its image (nx_api/contract/program_image.h); node_now()
 * turns it into virtual time. Every call enters with node_enter(), which lets all earlier events of the
 * machine happen first, and ends with node_leave().
 */
#ifndef NODE_NODE_H
#define NODE_NODE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include "kernel/cache.h"
#include "kernel/fiber.h"
#include "kernel/vtime.h"
#include "kernel/workers.h"
#include "node/waits.h"
#include "nx_api/contract/message.h"
#include "nx_api/contract/ids.h"

#define NODE_REGION ((uintptr_t)1 << 30)

struct node;
struct node_image;  /* a program file, read once: image.h */
struct node_heap;   /* heap.h */
struct node_system; /* what all nodes share: machine file, event queue, network, output: system.h */
struct nxc_image;   /* nx_api/contract/program_image.h */
struct node_crash;  /* what is known of a program's crash: machine/crash.h */

enum node_state { NODE_COMPUTING, NODE_BLOCKED, NODE_ENDED };

/* Why a node ended. */
enum node_end { NODE_RUNNING, NODE_RETURNED, NODE_EXITED, NODE_KILLED, NODE_CRASHED, NODE_NOT_LOADED };

struct node_clock {
    vtime now;        /* at the last synchronisation */
    uint64_t units;   /* cost units spent up to it */
    int64_t given;    /* what *left was set to then */
    vtime stolen;     /* system time not yet added to the program's: see cpu.c */
    uint64_t unit_ps; /* of a cost unit, 0 if that is no whole number; clock_set */
    bool runs;        /* the program has control: it may have spent some */
};

/* clock.h; in units. */
struct node_looks {
    uint64_t quiet;          /* the program makes no call before; less than clock.units: it may at any time */
    uint64_t given_at, look; /* when the program got control; the next look */
    uint64_t known_at;       /* when it last did so in the order of events: clock_given_in_turn */
};

/* What the operating system has the processor for. */
enum node_task {
    NODE_SENDING,   /* the steps of the protocol at the sender; what is passed on, too */
    NODE_RECEIVING, /* and at the receiver */
    NODE_CALL,      /* calls that neither send nor receive here and now */
    NODE_COPYING,   /* from system buffers */
    NODE_INTERRUPT, /* into and out of handlers */
    NODE_FEEDING,   /* the channel, by hand */
    NODE_EMPTYING,  /* it */
    NODE_TASKS
};

/* A node's time, less that without a program, is the sum of computing (its cost units), idle and system, to the picosecond. The tasks' sum is system
 * and beside: a wait may be over while the processor still moves bytes, which does not hold up the program. */
struct node_stats {
    vtime system; /* in the operating system: calls, messages, interrupts */
    vtime tasks[NODE_TASKS];
    struct node_waits waits; /* of idle: in which calls, for which messages */
    uint64_t sent, sent_bytes;
    vtime idle;   /* waiting in a call, and the processor at rest */
    vtime beside; /* tasks that took none of the program's time */
    size_t memory_peak;
    uint64_t handlers;
    vtime stood;  /* that the program stood still for handlers, and did not wait */
    vtime latest; /* longest delay between an interrupt being due and its handler starting, unmasked */
    vtime ended_at;
    vtime
        away; /* without a program: before it was loaded, between two, and what is less than a unit's time when one is
                 * killed. Modulo 2^64: system time that a killed one had begun counts as spent. */
};

/* A program that computes ahead, on any thread: cpu.c. */
struct node_ahead {
    bool paused; /* it has stopped at a check, to be gone on with */
    bool alert;  /* a handler may have to run: it computes up to a horizon only */
    /* not 0: it only makes up for what it has been let off so far: node_catch_up; or it is lent, and loose, until then */
    vtime up_to;
    struct work work;
    vtime check;   /* when the program is stopped at a check: its time */
    vtime arrived; /* when not paused: the time of its next call, or check if it was lent */
    /* for a guess at its next stretch, with workers: sets of calls */
    uint64_t after;      /* its last */
    uint64_t long_after; /* those behind which it computed for long the last time */
};

/* Messages and what they are for: mailbox.h. A line of the cache. */
struct mailbox {
    struct posted posted;
    struct message *whole, **whole_end; /* unexpected.h */
    struct due *last_due;               /* of a ring: its next is the first. NULL: none */
    uint32_t handlers;                  /* posted or due */
    uint32_t waiting;                   /* unexpected long messages that found no room */
    struct mailbox_ids ids;
};
_Static_assert(sizeof(struct mailbox) == CACHE_LINE, "a mailbox does not fit into a line");

/* Times that are noted of pending calls, and the node's clock: 20 hours. */
enum { PENDING_TIME_BITS = 56 };

/* A node's messages that wait for their turn should still be in the caches then. */
enum { PENDING_MOST = 16 };

/* A call whose turn is still to come, although the program has gone on: pending.h. What it takes is in the node's books at
 * once, and comes out of them if it is taken back. */
struct pending_call {
    uint64_t turn : PENDING_TIME_BITS; /* less node_pending.late at its beginning */
    bool has_type : 1;                 /* pending_beside.type */
    bool has_memory : 1;               /* pending_beside.memory */
    bool in_turn : 1;                  /* is to be made in its turn */
    bool posts : 1;                    /* receive, when it is made */
    bool selected : 1;    /* receive has had its message from those that waited, before its turn */
    bool has_message : 1; /* to be sent, and not begun */
    bool sends : 1;       /* message has been sent before its turn */
    uint64_t units : PENDING_TIME_BITS; /* the node's clock then */
    bool goes_on : 1; /* when it has handed over what it has to, it is there already, what it waits for */
    bool takes : 1;   /* that */
    bool plain : 1;   /* it is one message that needs no look any more, and is free then */
    bool beside : 1;  /* message is in pending_beside, for it has a receive, too */
    vtime spent;
    union {
        struct receive *receive; /* if it posts or selected */
        struct message *taken;   /* if it takes; linked by next */
        struct message *message; /* if it has any, not beside */
    };
    const char *name; /* of the call */
};

/* All of them: node.calls. */
struct node_pending {
    uint16_t first, count;
    bool selects; /* one of them is a receive that may select a message in its turn */
    bool open;    /* the program is in the last of them */
    bool drains;  /* it goes on when none is left, whatever its time */
    vtime turn;   /* of the first, or when it goes on; later by what has been stolen since then */
    vtime begun;  /* when the first began, if it is to go on; VT_NEVER: it has not begun */
    vtime late;   /* all come so much later than noted, and what has been stolen since then */
    vtime told;   /* the event queue knows of this turn; 0: of none */
};

/* What the program has of its memory: bytes of heap in use, and the most of all so far. */
struct node_memory {
    size_t heap, peak;
};

/* What of pending calls is hardly ever asked for. */
struct pending_beside {
    struct message *message[PENDING_MOST];
    struct node_memory
        memory[PENDING_MOST];   /* the program's at the call, if it has changed since the one before */
    int32_t type[PENDING_MOST]; /* in node.call_type when it goes on, if it has any */
};

/* Where a program was at a look. */
struct node_look {
    uint64_t units;
    uintptr_t at; /* behind the poll */
};
enum { NODE_LOOKS = 16 };

/* What hardly any program uses, or not for each message: in another place, so that what all use lies close together. */
struct node_beside {
    struct id_block ids; /* the first of the mailbox's */
    struct pending_beside calls;
    struct own_calls own;
    struct node_look looks[NODE_LOOKS]; /* the latest; a ring */
    uint32_t look_count;                /* of all */
    struct node_error error;
};

/* What a message that comes needs lies in the node's first block of the cache (cache.h), up to what stats tell of sending and
 * receiving; in one line behind it what stats tell of most calls; then some calls; and from fiber.self up to ahead.up_to what
 * else most calls need. */
struct node {
    struct mailbox mailbox;
    struct node_clock clock;
    vtime sys_free; /* the operating system is busy with messages until then */

    uint32_t
        system_milli; /* its system takes so many thousandths of an ordinary node's time for everything */
    uint32_t place;   /* on the network: its id, except for the host's */
    enum node_state state;
    bool is_host;
    bool armed;   /* posted a handler at any time */
    bool loose;   /* ahead.work: only the thread that runs it may touch what the program may */
    bool stopped; /* at a check, for which it is in node_system.checks */
    bool rests;   /* it waits, at its turn, of which the queue knows nothing, it will be blocked: turns.h */
    bool call_has_type, awaits; /* see call */
    bool hands_over;            /* the call was entered by node_enter_early, and has not waited */
    bool heap_moved;            /* heap_used has changed since the program was last in a call */
    struct node_system *sys;
    struct node_pending pending;

    /* what the program has switched away for, ready NULL: nothing but its turn (cpu.c) */
    struct {
        bool (*ready)(struct node *n, void *arg);
        void *arg;
    } wait;
    struct node_stats stats;
    _Alignas(CACHE_LINE) struct pending_call calls[PENDING_MOST]; /* a ring */

    struct fiber fiber;
    struct {
        vtime since, busy; /* stats.system then */
    } blocked;
    struct node_crash *crash; /* NULL: none */
    /* the call the program is in, for reports; NULL while it computes */
    const char *call;
    vtime call_since;
    /* its image's: to count its cost units, and what it promises. NULL: there is none */
    int64_t *left, *quiet;
    struct node_looks looks;
    int saved_errno;
    bool masked, in_handler;
    long call_type; /* type, typesel or id it was given, if call_has_type */
    long awaited;   /* type or typesel of the message the call is about, if awaits */
    uintptr_t
        frame; /* on the stack: of the call, while it is blocked, or of the poll at which it has stopped */
    struct node_info info;
    struct message *coming; /* unexpected.h, as the next three */
    struct queues *by_type; /* the whole ones; NULL: they are few */
    uint32_t whole_count;
    int64_t whole_order; /* of the last, in by_type */
    size_t buffered;     /* bytes of unexpected messages held */
    /* Messages come while the program computes ahead. Each of the two sees what the other had when the program was last
     * in a call. */
    size_t buffered_known;
    long pid;               /* process type: 0, unless the program has set it */
    struct receive receive; /* of the blocking call that the program is in, outside of handlers */
    struct node_ahead ahead;

    struct node_heap *heap;
    size_t heap_used, heap_known; /* of it; known: as buffered_known */
    size_t taken;                 /* of `buffered`: what the program has received from in pending calls */
    size_t peak_ahead;            /* memory_peak as the program sees it */
    size_t image_bytes;           /* program text, data and bss, page rounded */
    struct nxc_image *image;      /* of the program */
    struct node_beside *beside;
    struct node_error *error; /* beside's */
    char name[16];            /* for people: "node 3", "host" */
    uint32_t id;
    uint64_t clock_hz;
    struct node_region *region;                /* NULL: it has no program */
    char *span, *stack, *program, *heap_start; /* of the region; the lowest bytes of each: span.h */
    size_t stack_bytes;                        /* there; those the machine file gives, or some more */
    const struct node_image *file;
    int argc;
    char **argv, **envp;

    bool stripped; /* another has taken its place: nobody but late events knows of it */
    enum node_end end;
    int exit_code;
    bool at_poll;     /* it has stopped at one, at `frame` */
    bool cut_short;   /* while it computed; its image knows nothing of that */
    bool awaits_end;  /* is in a call that waits for another node's end */
    bool end_noticed; /* such a call has told of this one's */
    struct {
        vtime at;
        uint64_t units; /* what the program had computed then */
    } opened;           /* when handlers were last let run */
    uint64_t
        share_until; /* no handler interrupts the program before its clock has so many units: handlers.h */
    struct node_libc *libc; /* stdio, random numbers, strtok: libc.h */
    size_t failed_malloc;   /* size of the last allocation refused, 0: none */
};

_Static_assert(offsetof(struct node, stats.tasks[NODE_RECEIVING + 1]) <= CACHE_BLOCK,
               "what a message needs does not fit into a node's first block");
_Static_assert(offsetof(struct node, stats.beside) <= CACHE_BLOCK + CACHE_LINE,
               "what stats tell of most calls does not fit into a line behind it");

/* What is guarded against running over: in the order of what it costs. */
enum node_guards { NODE_GUARDS_NONE, NODE_GUARDS_STACKS, NODE_GUARDS_ALL };

/* The start of a region: which nodes its spans and heaps belong to, and how they are made. */
struct node_region {
    uint64_t shift;                 /* a span has 2^shift bytes */
    uint64_t heaps_at, heap_stride; /* offset of the first heap, and from each to the next */
    uint64_t heap_bytes;            /* of each, less than heap_stride */
    uint32_t spans, fresh, used;    /* spans: in all; the first that nobody has had yet; taken */
    enum node_guards guards;
    bool light_guards, copies_text, low; /* low: below 2^32 */
    struct node_region *next;            /* with room: node_system.roomy */
    struct node *node[];                 /* by span */
};

/* The node in whose memory an address lies: in the program, its stack or its heap. It has to lie in some node's region. */
static inline struct node *node_at_address(uintptr_t address)
{
    const struct node_region *r = (const struct node_region *)(address & ~(NODE_REGION - 1));
    uint64_t offset = address & (NODE_REGION - 1);
    uint64_t slot = offset < r->heaps_at ? offset >> r->shift : (offset - r->heaps_at) / r->heap_stride;
    return r->node[slot];
}

/* The node that runs the caller: on its stack, or on one that the program has made in its own memory. */
static inline struct node *node_self(void)
{
    return node_at_address((uintptr_t)__builtin_frame_address(0));
}

/* Does an address lie in its memory? */
static inline bool node_owns(const struct node *n, uintptr_t address)
{
    const struct node_region *r = n->region;
    return r && (address - (uintptr_t)n->span < (uintptr_t)1 << r->shift ||
                 address - (uintptr_t)n->heap_start < r->heap_bytes);
}

/* Does the caller run on this node? */
static inline bool node_is_self(const struct node *n)
{
    return node_owns(n, (uintptr_t)__builtin_frame_address(0));
}

/* --- calls: clock.c, cpu.c --- */

/* The node's time now, its computing included. */
vtime node_now(struct node *n);
/* Enter a call: brings the clock up to date, waits until the call is the machine's earliest event, runs
 * handlers due. */
void node_enter(struct node *n, const char *call);
/* The same for a call that only hands something over, or first does that and then waits (node_wait): the program goes on at
 * once, and the call is made in its turn (pending.h). */
void node_enter_early(struct node *n, const char *call);
/* Waits until this moment of the node is the machine's earliest event, as node_enter does, but runs no
 * handlers: for library calls that show something to the outside (a write) in places that are not safe for a
 * handler. */
void node_order(struct node *n);
/* Spend operating system time in a call: NODE_CALL, or the task named. */
void node_spend(struct node *n, vtime t);
void node_spend_on(struct node *n, enum node_task task, vtime t);
/* Back to the program; every node_enter ends with it. (node_order needs none.) */
void node_leave(struct node *n);
/* End the program from inside one of its calls; never returns. */
_Noreturn void node_end_here(struct node *n, enum node_end how, int code);
/* The program has not come further, when another one ends it, or the machine stops. */
void node_stop(struct node *n, struct instant at);
/* End another node's program, at the time of the caller. */
void node_end_other(struct node *n, struct node *victim);
/* An error in an NX call: sets n->error, and is -1 so that a function can return it. */
long node_error(struct node *n, int code, const char *fmt, ...) __attribute__((format(printf, 3, 4)));
/* An error in a plain NX call: message naming call, node, time; ends the process (NX rule) with status 1. */
_Noreturn void node_fail(struct node *n, const char *fmt, ...) __attribute__((format(printf, 2, 3)));
/* The same from inside a library of the program: frame is that of its function which the program called, NULL unknown. */
_Noreturn void node_fail_in(struct node *n, const void *frame, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
/* Hand bytes the program wrote to its output (fd 1) or error output (fd 2) on, at the node's present time. */
void node_output(struct node *n, int fd, const char *bytes, size_t len);
/* An element of a program's array of longs: of 4 bytes in programs compiled with nxcc --long32. */
size_t node_long_bytes(const struct node *n);
long node_get_long(const struct node *n, const long *array, size_t i);
void node_put_long(const struct node *n, long *array, size_t i, long value);
/* Bytes of the node's memory in use, its heap as it was in its last call; and all a program may use. */
size_t node_memory_used(const struct node *n);
size_t node_memory_limit(const struct node *n);
/* Notes the high-water mark after a message has come. */
void node_memory_changed(struct node *n);
/* In a call: messages see all of the program's memory, and unless the call may be pending, the program theirs. */
void node_memory_settle(struct node *n);
/* The program's memory as it is; and for messages to see, as it was in a call that they have come to. */
struct node_memory node_memory_now(const struct node *n);
void node_memory_was(struct node *n, struct node_memory m);
/* errno of the thread that runs the caller now. A program may go on on another thread after node_leave() or any call
 * that orders it, and compilers take the place of errno to be the same throughout a function. */
int node_errno(void);
void node_set_errno(int error);
#endif
