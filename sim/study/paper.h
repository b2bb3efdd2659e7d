/* paper.h - the paper's tables and how their rows are run (bench/paper/paper.cfg), and what of the program's cost was
 * fitted to them (bench/paper/fitted.cfg). */
#ifndef STUDY_PAPER_H
#define STUDY_PAPER_H
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
};

struct paper_row {
    unsigned nodes;
    struct paper_figures paper;
    char *arguments; /* of the program, separated by spaces: equal texts are the same run */
};

struct paper_table {
    unsigned number;
    char *title;
    struct paper_row *rows;
    size_t count;
};

/* A choice that the paper leaves open and that was fitted to its figures. */
struct paper_choice {
    char *option;
    char *fitted_to;
};

struct paper {
    char *machine; /* to run them on */
    char *program; /* relative to where the built programs are */
    struct paper_table *tables;
    size_t count;
    struct paper_choice *choices;
    size_t choice_count;
};

/* Each reads a file; NULL with a malloc'd *error for the user. */
struct paper *paper_read(const char *path, char **error);
void paper_free(struct paper *p);

/* A cost factor of the program that was fitted to a figure. */
struct paper_factor {
    char *file, *function; /* what it applies to; either may be NULL: all */
    double factor;
    char *fitted_to;
};
struct paper_fitted {
    struct paper_factor *factors;
    size_t count;
};
struct paper_fitted *paper_read_fitted(const char *path, char **error);
void paper_free_fitted(struct paper_fitted *f);
#endif
