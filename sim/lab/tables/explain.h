/* explain.h - the time of a row by what hosts and slaves did: the program's account of its activities
 * (its option -times), and the simulator's account of the processors. Both must add up to the nodes' time;
 * explain_read() checks that. */
#ifndef LAB_TABLES_EXPLAIN_H
#define LAB_TABLES_EXPLAIN_H
#include "lab/jobs/outcome.h"
#include "lab/tables/paper.h"

enum explain_class { EXPLAIN_HOSTS, EXPLAIN_SLAVES, EXPLAIN_CLASSES };

/* Seconds of all nodes of each class. */
struct explain_line {
    char *label;
    double s[EXPLAIN_CLASSES];
};

struct explain_part {
    struct explain_line *lines;
    size_t count;
};

enum { EXPLAIN_LAYER_FIGURES = 7 };
struct explain_layer {
    int layer, host;
    /* opened at, open for; of that time reading, helping, serving, packing, waiting */
    double s[EXPLAIN_LAYER_FIGURES];
};

struct explain {
    const struct paper_row *row;
    unsigned table;
    unsigned nodes[EXPLAIN_CLASSES];
    double total_s, plain_s;          /* of the run with -times, and of the run without */
    struct explain_part program;      /* adds up to nodes x total */
    double around_s[EXPLAIN_CLASSES]; /* time before the program's clock started and after it stopped */
    struct explain_part processor;    /* adds up to nodes x total plus around_s */
    struct explain_layer *layers;
    size_t layer_count;
};

/* Explains a row from its run with -times and its run without. NULL with *error malloc'd if figures are
 * missing or do not add up. */
struct explain *explain_read(const struct paper *p, const struct paper_row *row, unsigned table,
                             const struct outcome *timed, const struct outcome *plain, char **error);
void explain_free(struct explain *e);

/* Seconds of all lines of a class. */
double explain_sum(const struct explain_part *part, enum explain_class c);
#endif
