/* fit_parts.h - what the files of a fit (fit.h) share: fit_read.c and fit_table.c read it, fit_try.c and
 * fit_build.c evaluate, fit.c
 * conducts, fit_print.c and fit_write.c tell. */
#ifndef LAB_FIT_FIT_PARTS_H
#define LAB_FIT_FIT_PARTS_H
#include "lab/fit/fit.h"
#include "lab/fit/fit_least.h"

struct fit_parameter {
    const char *name, *set, *arguments, *factor; /* one of the latter three; the others NULL */
    double from, to, start;
    bool logarithmic;
};

struct fit_measurement {
    char *name; /* for people: "nodes 2: total_s" */
    char *figure;
    json_t *where; /* AXIS: its value as text */
    double value;
    double half;  /* half a unit of its last digit */
    double scale; /* what a residual of 1 is */
    char *at;     /* for messages: file:line */
};

struct fit {
    const struct fit_options *options;
    struct spec *spec;
    const char *data; /* the file of measurements; the study file if they are in it */
    struct fit_parameter parameter[FIT_MAX_NUMBERS];
    size_t parameters;
    struct fit_measurement *measurement;
    size_t measurements;
    bool by_rounding;  /* else relative */
    const char *build; /* NULL: no factors */

    /* Which parameters are looked for, and what the others are: from 0 to 1. */
    size_t searched[FIT_MAX_NUMBERS], count;
    double place[FIT_MAX_NUMBERS];

    double *computed; /* of the latest evaluation */
    unsigned evaluations;
    char *built;                /* the factors that the program was built with last */
    char *program;              /* where it is then; NULL: the study's own */
    struct study_counts counts; /* sums */
    char *error;
};

/* --- fit_read.c, fit_table.c --- */

bool fit_read(struct fit *f, char **error);
/* A row: COLUMN: text of each cell that is not empty. */
typedef bool fit_row(void *arg, const json_t *cells, const char *at, char **error);
/* Calls row for each of the file's, at: "FILE:LINE". False with *error. */
bool fit_table(const char *path, fit_row *row, void *arg, char **error);
/* The number, and half a unit of its last digit as it is written: 90.7 has 0.05. False unless it is one. */
bool fit_number(const char *text, double *value, double *half);
void fit_clear(struct fit *f);

/* --- fit_build.c --- */

/* Builds the program with the factors that the parameters have at these places, unless it is. False with f->error. */
bool fit_build(struct fit *f, const double place[]);
/* Text with `with` for each `hole`; malloc'd. */
char *fit_filled(const char *text, const char *hole, const char *with);

/* --- fit_try.c --- */

/* A parameter's value at a place from 0 to 1, and as text of six digits, which is what runs get. */
double fit_value(const struct fit_parameter *p, double place);
void fit_text(const struct fit_parameter *p, double place, char text[32]);
double fit_place(const struct fit_parameter *p, double value);
/* For fit_least(): x are the places of those searched. Leaves computed. arg: a struct fit. */
bool fit_try(void *arg, const double x[], double residuals[]);

/* --- what came of it --- */

struct fit_result {
    double *before, *after; /* computed, of each measurement */
    double rms_before, rms_after;
    struct fit_number number[FIT_MAX_NUMBERS]; /* of each parameter */
    double error[FIT_MAX_NUMBERS];             /* standard, in the parameter's unit */
    char text[FIT_MAX_NUMBERS][32], start[FIT_MAX_NUMBERS][32];
    double
        *percent; /* [measurement * parameters + parameter]: percent of the figure for one of the parameter */
};

void fit_print(const struct fit *f, const struct fit_result *r, FILE *out);
/* Says of a parameter what the data leave open; "" if nothing. Malloc'd. */
char *fit_said(const struct fit *f, const struct fit_result *r, size_t parameter);
bool fit_write(const struct fit *f, const struct fit_result *r, char **error);
#endif
