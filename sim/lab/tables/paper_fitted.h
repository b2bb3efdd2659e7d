/* paper_fitted.h - what was fitted to the paper's tables (bench/paper/fitted.cfg). */
#ifndef LAB_TABLES_PAPER_FITTED_H
#define LAB_TABLES_PAPER_FITTED_H
#include <stdbool.h>
#include <stddef.h>

/* A cost factor of the program that was fitted to a figure. */
struct paper_factor {
    char *file, *function; /* what the factor applies to; NULL: to all */
    double factor;
    char *fitted_to;
};

/* A constant that was fitted (an option of the program or a setting of the machine), or a policy of the
 * program that the paper leaves open and that was chosen with its tables in view. */
struct paper_choice {
    bool policy;
    char *what;
    char *fitted_to;
    char **instead; /* alternatives: arguments of the program, or "--set KEY=VALUE" for the machine */
    size_t instead_count;
};

struct paper_fitted {
    struct paper_factor *factors;
    size_t count;
    struct paper_choice *choices;
    size_t choice_count;
};
/* Reads fitted.cfg. NULL with *error malloc'd. */
struct paper_fitted *paper_read_fitted(const char *path, char **error);
void paper_free_fitted(struct paper_fitted *f);
#endif
