/* paper.h - the paper's tables and how their rows are run (bench/paper/paper.cfg), and what of the program's cost was
 * fitted to them (bench/paper/fitted.cfg). */
#ifndef LAB_TABLES_PAPER_H
#define LAB_TABLES_PAPER_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { PAPER_MAX_ARGS = 16 };

/* The figures that the paper gives of a run; a figure that is not given is NAN. */
struct paper_figures {
    double total_s;
    double host_idle_pct;
    double slave_idle_pct;
    double slave_idle_spread_pct;
    double speed_per_node;
    double total_unit_s; /* one in the last digit printed; NAN: not known */
};

struct paper_row {
    unsigned nodes;
    struct paper_figures paper;
    char *arguments; /* of the program, separated by spaces: equal texts are the same run */
    unsigned group;  /* nodes in a group; the first of each is its host */
    bool fitted;     /* a constant or choice was fitted to it */
    bool ties;       /* what happens turns on which of two things is first, if by nothing */
    char *remark;    /* a known reason for the difference; NULL none */
};

struct paper_table {
    unsigned number;
    char *title;
    struct paper_row *rows;
    size_t count;
};

/* What the program's messages of types first to last are called. */
struct paper_message {
    long first, last;
    char *name;
};

struct paper {
    char *machine; /* to run them on */
    char *program; /* relative to where the built programs are */
    struct paper_table *tables;
    size_t count;
    struct paper_message *messages;
    size_t message_count;
};

/* Each reads a file; NULL with a malloc'd *error for the user. */
struct paper *paper_read(const char *path, char **error);
void paper_free(struct paper *p);

/* "5:64": table 5, 64 nodes. False: no such text. */
bool paper_row_name(const char *text, unsigned *table, unsigned *nodes);
/* The row of that name; NULL none. */
struct paper_row *paper_find(const struct paper *p, const char *name);
/* NULL: the type has no name. */
const char *paper_message_name(const struct paper *p, long type);

/* A cost factor of the program that was fitted to a figure. */
struct paper_factor {
    char *file, *function; /* what it applies to; either may be NULL: all */
    double factor;
    char *fitted_to;
};

/* Another constant that was fitted: an option of the program or a number of the machine file; or a policy of the program
 * that the paper leaves open, chosen with its tables in view. */
struct paper_choice {
    bool policy;
    char *what;
    char *fitted_to;
    char **
        instead; /* what else might have been chosen: words for the program, or "--set KEY=VALUE" for the machine */
    size_t instead_count;
};

struct paper_fitted {
    struct paper_factor *factors;
    size_t count;
    struct paper_choice *choices;
    size_t choice_count;
};
struct paper_fitted *paper_read_fitted(const char *path, char **error);
void paper_free_fitted(struct paper_fitted *f);
#endif
