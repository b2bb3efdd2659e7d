/* race_findings.h - the races that were found on a node: each pair of places once, with its first instance
 * and a count. */
#ifndef RACES_RACE_FINDINGS_H
#define RACES_RACE_FINDINGS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "kernel/vtime.h"

enum race_what {
    RACE_OF_ACCESSES, /* the main program's and a handler's, which nothing orders */
    RACE_OF_UPDATE,   /* the main program reads and writes a volatile object that a handler writes, too */
    RACE_ON_SEND,     /* a buffer is written while it is sent */
    RACE_ON_RECEIVE,  /* a buffer is read or written while a receive into it is posted */
    RACE_OF_BUFFERS   /* a call is given a buffer of which a byte is under way for another call */
};

/* One side of a race. */
struct race_side {
    uint32_t place; /* races/race_places.h */
    bool write, in_handler;
    vtime at; /* the beginning of what the program computed then, or the call; VT_NEVER: long ago */
};

struct race_finding {
    enum race_what what;
    struct race_side earlier, later; /* in this run; of buffers under way: `earlier` is the call's */
    uintptr_t offset;                /* of the memory, from the program's start */
    uint64_t count, segment, before; /* the last segment in which it was found; the count before that */
    uint32_t next;
};

struct race_findings {
    struct race_finding *list; /* list[0] is not used */
    uint32_t count, room;
    /* found when there was no room left: RACE_MOST_FINDINGS, or RACE_MOST_PLACES; before this segment */
    uint64_t dropped, dropped_before;
    uint64_t segment; /* what the program computes now, up to its next call or its next handler */
    uint32_t *buckets;
};

enum { RACE_MOST_FINDINGS = 4096 };

/* Counts f, whose count is not read. Of a pair of places the first is kept, whichever came earlier. */
void race_findings_add(struct race_findings *t, const struct race_finding *f);
/* The program begins another segment. What was found in this one is not counted: a race that was found in no
 * other has a count of 0 then. */
void race_findings_begin_segment(struct race_findings *t);
void race_findings_forget_segment(struct race_findings *t);
void race_findings_end(struct race_findings *t);
#endif
