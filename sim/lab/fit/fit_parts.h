/* fit_parts.h - what the files of a fit (fit.h) share: fit_read.c and fit_table.c read the fit, fit_try.c and
 * fit_build.c evaluate it, fit.c conducts the search, fit_print.c and fit_write.c show the result. */
#ifndef LAB_FIT_FIT_PARTS_H
#define LAB_FIT_FIT_PARTS_H
#include "lab/fit/fit.h"
#include "lab/fit/fit_determine.h"

struct fit_parameter {
    const char *name, *set, *arguments, *factor; /* one of set, arguments and factor; NULL the others */
    double from, to, start;
    bool logarithmic;
};

struct fit_measurement {
    char *name; /* for people: "nodes 2: total_s" */
    char *figure;
    json_t *where; /* AXIS: its value as text */
    double value;
    double half;  /* half a unit of the value's last digit */
    double scale; /* the difference that makes a residual of 1 */
    char *at;     /* file:line, for messages */
};

struct fit {
    const struct fit_options *options;
    struct spec *spec;
    const char *data; /* the file of the measurements */
    struct fit_parameter parameter[FIT_MAX_NUMBERS];
    size_t parameters;
    struct fit_measurement *measurement;
    size_t measurements;
    bool by_rounding;  /* weights = "rounding"; otherwise "relative" */
    const char *build; /* the command; NULL: no parameter is a factor */

    /* The parameters that are searched, and all parameters' positions in their ranges, from 0 to 1. */
    size_t searched[FIT_MAX_NUMBERS], count;
    double position[FIT_MAX_NUMBERS];

    double *computed; /* figures of the latest evaluation; NAN: its run failed */
    unsigned evaluations;
    char **failed;              /* runs that failed, each once: parameters, point and reason */
    char *built;                /* the factors of the last build */
    char *program;              /* path of the built program; NULL: the study's own program */
    struct study_counts counts; /* sums over all evaluations */
    char *error;
};

/* --- fit_read.c, fit_table.c --- */

bool fit_read(struct fit *f, char **error);
/* A row of a table: COLUMN: text for each cell that is not empty. at: "FILE:LINE". */
typedef bool fit_row(void *arg, const json_t *cells, const char *at, char **error);
/* Calls row for each row of the file. False with *error. */
bool fit_table(const char *path, fit_row *row, void *arg, char **error);
void fit_clear(struct fit *f);

/* --- fit_position.c --- */

/* A parameter's value at a position from 0 to 1, and as text of six digits, which runs get. */
double fit_value(const struct fit_parameter *p, double position);
void fit_text(const struct fit_parameter *p, double position, char text[32]);
/* The position of a value. */
double fit_position(const struct fit_parameter *p, double value);

/* --- fit_build.c --- */

/* Builds the program with the factors at these positions, unless the last build had the same. False with
 * f->error. */
bool fit_build(struct fit *f, const double position[]);
/* text with `with` in position of each `hole`; malloc'd. */
char *fit_filled(const char *text, const char *hole, const char *with);

/* --- fit_try.c --- */

/* Evaluates the fit for fit_least(): x has the positions of the parameters that are searched, arg is a struct
 * fit. Sets f->computed. */
bool fit_try(void *arg, const double x[], double residuals[]);

/* --- the result: fit_print.c, fit_write.c, fit_json.c --- */

struct fit_result {
    double *before, *after; /* the computed figure for each measurement */
    double rms_before, rms_after;
    double *residuals;                         /* at the present positions */
    struct fit_number number[FIT_MAX_NUMBERS]; /* of each parameter */
    double error[FIT_MAX_NUMBERS];             /* the standard error in the parameter's unit */
    char text[FIT_MAX_NUMBERS][32], start[FIT_MAX_NUMBERS][32];
    /* [measurement * parameters + parameter]: percent of the figure for one percent of the parameter; NAN:
     * runs failed on both sides */
    double *percent;
};

void fit_print(const struct fit *f, const struct fit_result *r, FILE *out);
/* What the data leave open about a parameter, malloc'd; "" if nothing. */
char *fit_note(const struct fit *f, const struct fit_result *r, size_t parameter);
bool fit_write(const struct fit *f, const struct fit_result *r, char **error);
bool fit_write_json(const struct fit *f, const struct fit_result *r, char **error);
#endif
