/* recorder.h - writes the trace of a run (trace_format.h) while it goes on. The recorder knows nothing of
 * nodes and messages but what it is told; it changes nothing. Its memory is bounded by the number of
 * addresses, names and different stacks. All times are virtual, in picoseconds. */
#ifndef TRACE_RECORDER_H
#define TRACE_RECORDER_H
#include <jansson.h>
#include <stdio.h>
#include "kernel/vtime.h"
#include "trace/trace_format.h"

struct recorder;

struct recorder_options {
    FILE *out;
    vtime from, to;    /* what overlaps [from, to] is written; to VT_NEVER: to the end */
    const bool *nodes; /* by address, of node_count; NULL: all. Of messages, those with one end there */
    uint32_t node_count;
    uint32_t addresses; /* all are below */
};

/* Begins a trace with its head, which is read only. *o->nodes must last. */
struct recorder *recorder_new(const struct recorder_options *o, const json_t *head);
/* Writes the end; the recorder is gone, `out` stays open. An error of writing is left in `out`. */
void recorder_end(struct recorder *r, vtime end, uint64_t digest);
/* Is what happens at an address written? */
bool recorder_wants(const struct recorder *r, uint32_t address);

/* The number of a call's name, whose text must last; of a program's path; of a stack. */
uint32_t recorder_name(struct recorder *r, const char *name);
uint32_t recorder_program(struct recorder *r, const char *path);
uint32_t recorder_stack(struct recorder *r, uint32_t program, const uintptr_t *offsets, uint32_t depth);

struct recorded_wait {
    vtime begin, end, busy; /* busy: of it, the system had the processor */
    int64_t type;
    uint32_t from;
    uint8_t flags;
};

struct recorded_call {
    uint32_t address, name, stack; /* stack: number +1; 0 none */
    uint8_t flags;
    int64_t type;
    vtime begin, end;
    vtime ordered; /* when the call last waited for its turn: all earlier events have been seen */
    uint64_t sent_order, sent_count;
    uint32_t taken_source;
    uint64_t taken_order;
    vtime taken_at;
    struct recorded_wait *waits;
    uint32_t wait_count;
};

struct recorded_handler {
    uint32_t address, stack; /* as above */
    uint8_t flags;
    int64_t type;
    vtime due, begin, entered, left, end;
    uint32_t source;
    uint64_t order;
};

struct recorded_block {
    uint32_t channel;
    vtime begin, end; /* end VT_NEVER: it still waits */
};

struct recorded_message {
    uint32_t source; /* source and order together name a message */
    uint64_t order;
    uint32_t from, to;
    int32_t type, pid;
    uint64_t bytes;
    bool is_long;
    vtime sent, times[MESSAGE_TIMES]; /* VT_NEVER: it has not come so far */
    const struct recorded_block *blocks;
    uint32_t block_count;
};

void recorder_call(struct recorder *r, const struct recorded_call *c);
void recorder_handler(struct recorder *r, const struct recorded_handler *h);
/* charged: when the program was charged with it, not later than begin. */
void recorder_system(struct recorder *r, uint32_t address, uint32_t task, vtime charged, vtime begin,
                     vtime end);
void recorder_message(struct recorder *r, const struct recorded_message *m);
/* An address was without a program until t: a call by a name of its own says so. */
#define RECORDER_NO_PROGRAM "(no program)"
void recorder_no_program(struct recorder *r, uint32_t address, vtime t);
void recorder_node_end(struct recorder *r, uint32_t address, vtime t);
#endif
