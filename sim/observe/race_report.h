/* race_report.h - the races of a run, of all nodes: two places of the source each, with all that is known
 * of the first instance. */
#ifndef OBSERVE_RACE_REPORT_H
#define OBSERVE_RACE_REPORT_H
#include <stdbool.h>
#include <stddef.h>
#include "races/race_findings.h"

struct races;
struct node_image;
struct race_suppressions;

enum { RACE_MOST_FRAMES = 12 };

/* A line of the source. Texts last as long as the reports. */
struct race_frame {
    const char *function; /* "": not known */
    const char *file;     /* without its folder; "": not known */
    int line;
    bool in_layer; /* guest/layer.h */
};

struct race_report_side {
    bool reads, writes; /* in any of the instances */
    bool in_handler;
    const char *call; /* of NX, that reads or writes the buffer it was given; NULL: the program itself does */
    vtime at;         /* of the call, or the beginning of what the program computed then, or of the run */
    struct race_frame frames[RACE_MOST_FRAMES]; /* the innermost first; at least one */
    size_t depth;
    const char *posted_by; /* the call that posted the handler, and where; NULL: it is no handler's */
    struct race_frame posted;
};

struct race_report {
    enum race_what what;
    const char *variable;          /* "": not known */
    const struct node_image *file; /* of the instance: its program, and the memory's offset in it */
    uintptr_t offset;
    size_t group; /* the index of the first race of the same variable, of any kind; its own: there is none */
    struct race_report_side side[2]; /* the handler's first; or of buffers: the call's whose buffer it is */
    bool first_came_later;           /* in the instance: side[0] after side[1] */
    const char *node;                /* of the instance: "node 3", "host" */
    uint64_t count;                  /* instances, on all nodes */
    bool *on_node;                   /* by number + 1; 0: the host */
    size_t nodes;                    /* length of on_node */
    uint32_t first_number;           /* of on_node: that of `node` */
    size_t order;                    /* in which it was collected */
};

struct race_reports {
    struct race_report *list; /* in the order of the source */
    size_t count, groups;
    size_t suppressed;
    uint64_t dropped; /* instances of which nothing else is known */
    bool checked;     /* a program was built with --races */
    struct race_texts *texts;
};

/* Is it about a buffer under way, and not about two accesses? */
bool race_report_is_of_buffer(const struct race_report *r);
/* Of a machine that has run. s: NULL, or what is not to be reported. */
struct race_reports *race_reports_collect(const struct races *r, const struct race_suppressions *s);
void race_reports_free(struct race_reports *t);
#endif
