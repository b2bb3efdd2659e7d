/* paper.h - the paper's tables and how their rows are run (bench/paper/paper.cfg), and what was fitted to
 * them (bench/paper/fitted.cfg). */
#ifndef LAB_TABLES_PAPER_H
#define LAB_TABLES_PAPER_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The paper's figures of a run; NAN where the paper gives none. */
struct paper_figures {
    double total_s;
    double host_idle_pct;
    double slave_idle_pct;
    double slave_idle_spread_pct;
    double speed_per_node;
    double total_unit_s; /* one in the last printed digit of total_s; NAN: not known */
};

struct paper_row {
    unsigned nodes;
    struct paper_figures paper;
    char *arguments; /* of the program, separated by spaces; equal texts are the same run */
    unsigned group;  /* nodes in a group; the first of each is its host */
    bool fitted;     /* a constant or choice was fitted to the row */
    bool ties;       /* the row's time is sensitive to ties (tie_sensitivity.h) */
    char *remark;    /* a known reason for the difference; NULL if none */
};

struct paper_table {
    unsigned number;
    char *title;
    struct paper_row *rows;
    size_t count;
};

/* The name of the program's messages of types first to last. */
struct paper_message {
    long first, last;
    char *name;
};

struct paper {
    char *machine; /* the machine that all rows run on */
    char *program; /* relative to the folder of built programs */
    struct paper_table *tables;
    size_t count;
    struct paper_message *messages;
    size_t message_count;
};

void paper_free(struct paper *p);

/* Reads a row's name, "5:64": table 5, 64 nodes. False if text is no such name. */
bool paper_row_name(const char *text, unsigned *table, unsigned *nodes);
/* The row of that name; NULL if there is none. */
struct paper_row *paper_find(const struct paper *p, const char *name);
/* The name of messages of that type; NULL if they have none. */
const char *paper_message_name(const struct paper *p, long type);
#endif
