/* validate.h - compares our figures with published ones: the runs, their results, and their errors.
 *
 *     published.cfg --plan_read--> plan --measure--> plan with results --judge--> plan with errors
 *                   --report_*--> table, page, JSON
 */
#ifndef VALIDATE_H
#define VALIDATE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { MAX_SIZES = 16, MAX_PIECES = 4 };

struct found {
    char *name;
    double value;
};

/* y over one or two x. */
struct point {
    char *series;
    double x[2], y;
};

/* A program on a machine, for one or more numbers of nodes. */
struct run {
    const char *name, *program, *machine, *costs, *arguments;
    unsigned nodes[MAX_SIZES];
    size_t sizes;
    struct found *found;
    size_t found_count;
    struct point *points;
    size_t point_count;
};

enum verdict { WITHIN, OUTSIDE, KNOWN_MISS, OPEN };

/* A published figure: from low to high, which are equal for a single value; or open. */
struct figure {
    const struct run *run;
    const char *name, *text, *unit, *standing, *source, *miss;
    double low, high, within; /* within: the error allowed, a fraction */
    bool open, fitted;        /* fitted: a number of the machine was chosen by this figure */
    double simulated, error;
    enum verdict verdict;
};

/* A piece of a published formula, which is compared with every point of a series: for x[0] <= most the
 * formula is constant + per_x x[0] + per_y x[1]. */
struct piece {
    double most, constant, per_x, per_y;
};
struct curve {
    const struct run *run;
    const char *series, *text, *standing, *source;
    struct piece pieces[MAX_PIECES];
    size_t piece_count;
    bool fitted;
    double within;
    double worst; /* error, with its sign */
    const struct point *worst_at;
    size_t points;
    enum verdict verdict;
};

/* Series that are shown without a comparison. */
struct listing {
    const struct run *run;
    const char *title, *x, *y;
};

struct plan {
    struct run *runs;
    size_t run_count;
    struct figure *figures;
    size_t figure_count;
    struct curve *curves;
    size_t curve_count;
    struct listing *listings;
    size_t listing_count;
    const char *const *remarks; /* paragraphs for the page */
    size_t remark_count;
};

/* Reads the plan from the file path. False with *error set. */
bool plan_read(struct plan *p, const char *path, char **error);
/* Runs all programs, with touchstone, from the folder build; writes points into the folder out. False with
 * *error set. */
bool measure(struct plan *p, const char *build, const char *out, char **error);
/* Sets errors and verdicts. True if no figure is outside. */
bool judge(struct plan *p);

void report_terminal(const struct plan *p, FILE *f);
void report_page(const struct plan *p, FILE *f);
bool report_json(const struct plan *p, const char *path);
const char *verdict_name(enum verdict v);
#endif
