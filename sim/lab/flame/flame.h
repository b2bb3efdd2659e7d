/* flame.h - profiles of touchstone run --profile as trees of frames, one or two of them laid over each other.
 *
 * Times are virtual, in picoseconds, summed over nodes. Of two profiles the first is what changed from the
 * second: `now` and `before`. Of one profile all of `before` is 0. */
#ifndef LAB_FLAME_H
#define LAB_FLAME_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include "kernel/vtime.h"

enum flame_kind {
    FLAME_ROOT,
    FLAME_FUNCTION,
    FLAME_INLINED, /* a function that the compiler has put into the one above */
    FLAME_LIBRARY, /* a function of the C library, or another with a price in the cost table */
    FLAME_CALL,    /* of NX: the system's time for it */
    FLAME_WAITING, /* in the call above */
    FLAME_OTHER,   /* "(handlers)", "(interrupts)" ... */
    FLAME_KINDS
};

/* The two profiles. */
enum { FLAME_NOW, FLAME_BEFORE, FLAME_PROFILES };

struct flame_frame {
    enum flame_kind kind;
    char *name, *file;                            /* file: "" not known */
    int line;                                     /* where the function begins */
    vtime_sum self[FLAME_PROFILES];               /* in no frame above */
    vtime_sum total[FLAME_PROFILES];              /* with all frames called */
    struct flame_frame *parent, *children, *next; /* children by name */
};

/* What was computed in a line of source. */
struct flame_line {
    char *file;
    int line;
    char *function;
    vtime_sum time[FLAME_PROFILES];
};

struct flame {
    struct flame_frame *root;
    struct flame_line *lines; /* most time first; of two profiles, most changed first */
    size_t line_count;
    char *program[FLAME_PROFILES];  /* NULL: there is no such profile */
    uint32_t nodes[FLAME_PROFILES]; /* of those selected */
    vtime end[FLAME_PROFILES];      /* of the runs */
};

struct flame_selection {
    const bool *nodes; /* by number, node_count of them; NULL: all */
    uint32_t node_count;
};

/* Reads a profile, and another that it is compared with unless that is NULL. NULL with *error (malloc'd,
 * names the file) on failure. */
struct flame *flame_load(const char *path, const char *before, const struct flame_selection *s, char **error);
void flame_free(struct flame *f);

/* Is f of two profiles? Share of a frame's or line's time in all time, 0 to 1. */
bool flame_is_diff(const struct flame *f);
double flame_share(const struct flame *f, const vtime_sum time[FLAME_PROFILES], int profile);
const char *flame_kind_name(enum flame_kind k);

/* Writes: stacks as flamegraph.pl reads them, "main;relax;csend 12345", of two profiles with both times; a
 * table; nested objects "name", "value", "children" as d3-flame-graph reads them; a picture;
 * lines of source. */
void flame_write_folded(const struct flame *f, FILE *out);
void flame_write_text(const struct flame *f, FILE *out);
void flame_write_json(const struct flame *f, FILE *out);
void flame_write_svg(const struct flame *f, FILE *out);
void flame_write_lines(const struct flame *f, FILE *out);
void flame_write_lines_json(const struct flame *f, FILE *out);
#endif
