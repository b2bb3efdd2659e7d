/* node.h - one simulated node, composed of its parts. Each part belongs to a folder, which alone assigns
 * it (tests/house/check reads the names of owners in the comments):
 *
 *     lp                        sim/lp       the node as a logical process: clock, state, commit times
 *     mailbox, unexpected,      sim/os       messages, buffers, interrupts, deferred calls, the call under
 *         deferred, call, wait,              way, what it waits for, times, memory, the end
 *         handlers, times,
 *         stats, memory, end
 *     guest                     sim/guest    the loaded program and its address space
 *     the rest                  sim/machine  what the node is: set when it is made
 *
 * "calls" is nx_api: contract, calls, sim.
 *
 * A node's program, stack and heap lie in a region of address space (span.h), so that a call finds its
 * node from the stack pointer (self.h), and no state is global or thread-local. The system runs on a stack
 * of its own there (kernel/crossing.h). */
#ifndef NODE_NODE_H
#define NODE_NODE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "kernel/prefetch.h"
#include "lp/lp.h"
#include "node/waits.h"
#include "nx_api/contract/message.h"
#include "nx_api/contract/ids.h"

struct node;
struct node_image;  /* a program file, read once: guest/image.h */
struct node_heap;   /* guest/heap.h */
struct node_libc;   /* guest/libc/libc.h */
struct node_region; /* node/self.h */
struct node_system; /* what all nodes share: node/system.h */
struct nxc_image;   /* nx_api/contract/program_image.h */
struct observer;    /* hears of what happens to the node: os/observer.h */
struct nxm_library; /* mpi_api/core/library.h */
struct node_asan;   /* which memory its program may access: asan/node_asan.h */
struct node_crash;  /* what is known of a program's crash: machine/crash.h */

/* Why a node ended. */
enum node_end { NODE_RUNNING, NODE_RETURNED, NODE_EXITED, NODE_KILLED, NODE_CRASHED, NODE_NOT_LOADED };

/* Where a program's text comes from: the node has its own; or that of its place in the machine's texts
 * (guest/span_texts.h), to which this node's is to be written. */
enum node_text { TEXT_OWN, TEXT_SHARED, TEXT_TO_SHARE };

/* What the operating system has the processor for. */
enum node_task {
    NODE_SENDING,   /* the steps of the protocol at the sender; what is forwarded, too */
    NODE_RECEIVING, /* and at the receiver */
    NODE_CALL,      /* calls that neither send nor receive here and now */
    NODE_COPYING,   /* from system buffers */
    NODE_INTERRUPT, /* into and out of handlers */
    NODE_FEEDING,   /* programmed I/O to the channel */
    NODE_EMPTYING,  /* and from the channel */
    NODE_TASKS
};

/* The system's time. A node's time, less that without a program, is the sum of computing (its cost units),
 * idle and system, to the picosecond. The sum of the tasks is system and overlapped: a wait may be over while
 * the processor still moves bytes, which does not hold up the program. */
struct node_times {
    vtime sys_free; /* the system is busy with messages until then */
    vtime system;   /* in the operating system: calls, messages, interrupts */
    vtime tasks[NODE_TASKS];
};

struct node_stats {
    uint64_t sent, sent_bytes;
    vtime idle;              /* waiting in a call, and the processor idle */
    vtime overlapped;        /* tasks that took none of the program's time */
    struct node_waits waits; /* of idle: in which calls, for which messages */
    size_t memory_peak;
    uint64_t handlers;
    vtime stood;  /* that the program stood still for handlers, and did not wait */
    vtime latest; /* longest delay between an interrupt being due and its handler starting, unmasked */
    vtime ended_at;
    /* Without a program: before it was loaded, between two, and less than a unit's time of a killed one.
     * Modulo 2^64: system time that a killed program had begun counts as spent. */
    vtime away;
};

/* Messages and what they are for: nx_api/contract/message.h. A line of the cache. */
struct mailbox {
    struct posted posted;
    struct message *whole, **whole_end; /* os/unexpected.h */
    struct due *last_due;               /* of a ring: its next is the first. NULL: none */
    uint32_t handlers;                  /* posted or due */
    uint32_t waiting;                   /* unexpected long messages that found no room */
    struct mailbox_ids ids;
};
_Static_assert(sizeof(struct mailbox) == CACHE_LINE, "a mailbox does not fit into a line");

/* Commit times that are noted of deferred calls, and the node's clock: 20 hours. Calls are deferred in the
 * first half of them. */
enum { DEFERRED_TIME_BITS = 56 };

/* A node's messages that wait to be committed should still be in the caches then. */
enum { DEFERRED_MOST = 16 };

/* A call that the program has left before its commit time: os/deferred.h. What the call takes is in the
 * node's books at once, and comes out of them if the call is rolled back. */
struct deferred_call {
    uint64_t commits : DEFERRED_TIME_BITS; /* commit time, less deferred.shift at its beginning */
    bool has_type : 1;                     /* deferred_cold.type */
    bool has_memory : 1;                   /* deferred_cold.memory */
    bool selected : 1;    /* receive has had its message from the unexpected, before its commit time */
    bool has_message : 1; /* to be sent, and not begun */
    bool sends : 1;       /* message has been sent before its commit time */
    uint64_t units : DEFERRED_TIME_BITS; /* the node's clock then */
    bool resumes_caller : 1;   /* the caller resumes at once: the message it waits for has arrived */
    bool consumes_message : 1; /* that message */
    bool inline_message : 1;   /* it is one, all in itself: it can be freed without a look at it */
    bool cold : 1;             /* message is in deferred_cold, for the call has a receive, too */
    bool asks : 1;             /* it asks, and has been answered no; so have those before it */
    vtime spent;
    union {
        struct receive *receive;  /* if it posts (deferred.posts) or selected */
        struct message *consumed; /* if it consumes; linked by next */
        struct message *message;  /* if it has any, not cold */
    };
    const char *name; /* of the call */
};

/* The calls themselves are in node.calls. */
struct deferred {
    uint8_t first, count;
    bool open;            /* the program is in the last of them */
    bool never;           /* os, machine: no call is deferred: for an observer or handlers, or ever */
    uint16_t posts;       /* sets of places in the ring: the call posts its receive when it is made; */
    uint16_t needs_event; /* is to be made at its commit time: sends, or may select a message then */
    vtime commits; /* of the first, or when its caller resumes; later by what has been stolen since then */
    vtime begun;   /* when the first began, if its caller is to resume; VT_NEVER: it has not begun */
    vtime shift;   /* all are so much later than noted, and by what has been stolen since then */
};

/* What a deferred call notes of its program's memory: bytes of heap in use, and the most of all so far. */
struct memory_mark {
    size_t heap, peak;
};

/* What of deferred calls is hardly ever asked for. */
struct deferred_cold {
    struct message *message[DEFERRED_MOST];
    vtime sending[DEFERRED_MOST]; /* the time to send it */
    struct memory_mark
        memory[DEFERRED_MOST]; /* the program's at the call, if it has changed since the one before */
};

/* The call that the program is in, for reports. A handler makes calls of its own; afterwards this is again
 * what it was. */
struct node_call {
    const char *name; /* NULL: the program computes */
    vtime since;
    long type;    /* type, typesel or id it was given, if has_type */
    long awaited; /* type or typesel of the message the call is about, if awaits */
    bool has_type, awaits;
    bool hands_over; /* it was entered by node_enter_early, and has not waited */
    bool asks;       /* by node_enter_asking, and neither is deferred nor has seen earlier events */
};

/* What the program has switched away for. */
struct node_stopped {
    bool (*ready)(struct node *n, void *arg); /* NULL: nothing but its commit time */
    void *arg;
    uintptr_t frame; /* on the stack: of the call while it is blocked, or of the poll where it has stopped */
    bool at_poll;    /* it has stopped at one */
    vtime system;    /* times.system when it began to wait */
};

/* Handlers of the program: os/handlers.h, share.h. */
struct node_handlers {
    bool armed; /* it has posted one at any time */
    bool masked;
    uint64_t share_until; /* none interrupts the program before its clock has so many units */
    /* When they were last let run, and what the program had computed then. */
    vtime opened_at;
    uint64_t opened_units;
};

/* Unexpected messages, beside those of the mailbox: os/unexpected.h. */
struct node_unexpected {
    struct message *coming; /* not yet whole */
    struct queues *by_type; /* the whole ones; NULL: they are few */
    uint32_t count;
    int64_t order; /* of the last, in by_type */
};

/* Bytes of the node's memory. Messages come while the program computes ahead; so each side reckons with what
 * the other had when the program was last in a call: heap_known, buffered_known. */
struct node_memory {
    size_t heap, heap_known;         /* that the program has in use */
    size_t buffered, buffered_known; /* unexpected messages */
    size_t taken;                    /* of `buffered`: what the program has received from in deferred calls */
    size_t peak_ahead;               /* node_stats.memory_peak as the program sees it */
    bool heap_moved;                 /* heap has changed since the program was last in a call */
};

/* The loaded program, and where in the node's span its parts lie: guest/image.h, span.h. */
struct node_guest {
    struct node_region *region;                               /* NULL: the node has no program */
    char *span, *system_stack, *stack, *program, *heap_start; /* the lowest bytes of each */
    size_t stack_bytes;                                       /* those the machine file gives, or some more */
    char *data;                                               /* of the program, behind text and constants */
    enum node_text text;
    bool heap_guarded; /* span_guard_heap */
    bool runs_stack;   /* the program puts code there */
    const struct node_image *file;
    struct nxc_image *image;
    size_t image_bytes; /* text, data and bss, page rounded */
    struct node_heap *heap;
    struct node_libc *libc; /* streams, random numbers, strtok: guest/libc/libc.h. NULL: not used yet */
};

/* How the node ended, and how the ends of others are heard of. */
struct node_ending {
    enum node_end how;
    int exit_code;
    bool cut_short; /* while it computed; its image knows nothing of that */
    bool awaits;    /* it is in a call that waits for another node's end */
    bool noticed;   /* such a call has told of this one's */
};

enum { REFUSAL_CALLS = 8 };

/* guest: of the last allocation that was refused. */
struct node_refusal {
    size_t bytes;                     /* asked for; 0: none was refused */
    size_t used, heap;                /* in use then, of the node's memory and of the program's heap */
    uintptr_t returns[REFUSAL_CALLS]; /* where the calls under way return to, the innermost first */
    int depth;
};
enum { NODE_EXIT_CALLS = 6 };

/* What hardly any program uses, or not for each message: in another place, so that what all use lies close
 * together. What many programs never use is made when it is used first: NULL until then. */
struct node_cold {
    int32_t deferred_type[DEFERRED_MOST]; /* os: in node.call.type when the caller resumes, if it has any */
    struct deferred_cold *deferred;       /* os */
    struct own_calls own;
    struct node_error *error;      /* calls */
    struct node_crash *crash;      /* machine. NULL: none */
    char name[16];                 /* for people: "node 3", "host" */
    int argc;                      /* guest */
    uint32_t program;              /* machine: which of the run's programs, from 0 */
    char **argv;                   /* guest: the program's, in its memory */
    char **envp;                   /* as the user has given it: own_memory.h */
    const struct nxm_library *mpi; /* core: what the program has of MPI's objects. NULL: it has called none */
    struct node_refusal refusal;
    /* machine: where the calls under way return when the program has called exit, the innermost first; a 0
     * ends them early */
    uintptr_t exit_calls[NODE_EXIT_CALLS];
};

/* What a message that comes needs lies in the node's first block of the cache (prefetch.h); behind it what
 * else most calls need, up to `stats`. So the order is not that of the owners. */
struct node {
    struct mailbox mailbox;   /* os */
    struct deferred deferred; /* os */
    struct node_system *sys;
    uint32_t
        system_milli; /* its system takes so many thousandths of an ordinary node's time for everything */
    bool is_host;
    bool in_handler;         /* os */
    bool stripped;           /* another has taken its place: nobody but late events knows of it */
    struct node_times times; /* os */
    uint64_t heard;          /* os: what the observers want to be told: os/observer.h */
    struct lp lp;            /* lp */

    struct node_stopped wait;   /* os */
    struct node_call call;      /* os */
    struct observer *observers; /* os. NULL: nobody observes the node */
    struct node_asan *asan;     /* machine. NULL: the program was built without --asan */
    vtime in_kernel; /* os: the program is in a kernel below NX until then, for a message of its own */
    struct node_handlers handlers;     /* os */
    struct node_info info;             /* os, calls */
    struct node_memory memory;         /* os */
    struct node_unexpected unexpected; /* os */
    long pid;                          /* calls, machine: process type: 0, unless the program has set it */
    struct receive receive;  /* os: of the blocking call that the program is in, outside of handlers */
    struct node_stats stats; /* os */
    _Alignas(CACHE_LINE) struct deferred_call calls[DEFERRED_MOST]; /* os: a ring */

    struct node_guest guest; /* guest */
    struct node_cold *cold;
    uint32_t id;
    struct node_ending end; /* os */
};

_Static_assert(offsetof(struct node, lp.drains) <= CACHE_BLOCK,
               "what a message needs does not fit into a node's first block");

/* The node that is this logical process. */
static inline struct node *node_of(const struct lp *lp)
{
    return (struct node *)((const char *)lp - offsetof(struct node, lp));
}
#endif
