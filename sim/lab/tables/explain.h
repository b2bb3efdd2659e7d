/* explain.h - where the time of a row went: for hosts and slaves, what the program says of itself (its option -times), and
 * what the simulator says of the processors. Both account for the same seconds, all of them: that is checked.
 */
#ifndef LAB_TABLES_EXPLAIN_H
#define LAB_TABLES_EXPLAIN_H
#include <stdio.h>

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
    double s
        [EXPLAIN_LAYER_FIGURES]; /* opened at, open for; of that reading, helping, serving, packing, waiting */
};

struct explain {
    const struct paper_row *row;
    unsigned table;
    unsigned nodes[EXPLAIN_CLASSES];
    double total_s, plain_s;          /* of the run that was measured, and of the one that was not */
    struct explain_part program;      /* adds up to nodes x total */
    double around_s[EXPLAIN_CLASSES]; /* before the clock started and after it stopped */
    struct explain_part processor;    /* adds up to nodes x total and around_s */
    struct explain_layer *layers;
    size_t layer_count;
};

/* Of a run with -times and the same without. NULL with *error set: figures are missing, or do not add up. */
struct explain *explain_read(const struct paper *p, const struct paper_row *row, unsigned table,
                             const struct outcome *timed, const struct outcome *plain, char **error);
void explain_free(struct explain *e);

double explain_sum(const struct explain_part *part, enum explain_class c);

/* As text for people, layers too; and in short as a table in Markdown. */
void explain_print(const struct explain *e, FILE *out);
void explain_markdown(const struct explain *e, FILE *out);
#endif
