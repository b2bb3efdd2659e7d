/* fit_determine.c - which numbers the residuals determine; see fit_least.h. */
#include "lab/fit/fit_least.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>

/* What counts as nothing beside the largest singular value: the slopes are differences of times that are exact to 1e-12. */
static const double NOTHING = 1e-9;
/* A standard error of more than this part of a range says that the data leave the number open. */
static const double OPEN = 0.25;
/* Numbers with less than this share of a combination are no part of it. */
static const double SHARE = 0.1;

/* slope = U S V': S, and V with its columns the combinations. Rows of zeros are added where there are too few. */
static void decompose(const double slope[], size_t rows, size_t n, gsl_matrix *v, gsl_vector *s)
{
    gsl_matrix *u = gsl_matrix_calloc(rows > n ? rows : n, n);
    for (size_t i = 0; i < rows; i++)
        for (size_t k = 0; k < n; k++)
            gsl_matrix_set(u, i, k, slope[i * n + k]);
    gsl_linalg_SV_decomp_jacobi(u, v, s);
    gsl_matrix_free(u);
}

static bool has_influence(const double slope[], size_t rows, size_t n, size_t k)
{
    for (size_t i = 0; i < rows; i++)
        if (slope[i * n + k] != 0)
            return true;
    return false;
}

/* The standard error of combination c. */
static double error_of(const gsl_vector *s, size_t c, double scatter)
{
    double singular = gsl_vector_get(s, c);
    return singular > NOTHING * gsl_vector_get(s, 0) ? scatter / singular : INFINITY;
}

/* Combination c is open: what that says of each number in it. */
static void mark(const gsl_matrix *v, size_t c, size_t n, struct fit_number of[])
{
    for (size_t k = 0; k < n; k++)
        for (size_t other = 0; other < n; other++) {
            double own = gsl_matrix_get(v, k, c), its = gsl_matrix_get(v, other, c);
            if (k == other || own * own < SHARE || its * its < SHARE || of[k].standing == FIT_NO_INFLUENCE ||
                of[other].standing == FIT_NO_INFLUENCE)
                continue;
            of[k].standing = FIT_TOGETHER;
            of[k].with[other] = true;
        }
}

void fit_determine(const double slope[], size_t residuals, size_t n, double scatter, struct fit_number of[])
{
    gsl_matrix *v = gsl_matrix_alloc(n, n);
    gsl_vector *s = gsl_vector_alloc(n);
    decompose(slope, residuals, n, v, s);
    for (size_t k = 0; k < n; k++) {
        double squares = 0;
        of[k] = (struct fit_number){0};
        for (size_t c = 0; c < n; c++) {
            double part = gsl_matrix_get(v, k, c), error = error_of(s, c, scatter);
            squares += fabs(part) < NOTHING ? 0 : part * part * error * error;
        }
        of[k].error = sqrt(squares);
        if (!has_influence(slope, residuals, n, k))
            of[k] = (struct fit_number){FIT_NO_INFLUENCE, INFINITY, {0}};
        else if (of[k].error > OPEN)
            of[k].standing = FIT_OPEN;
    }
    for (size_t c = 0; c < n; c++)
        if (error_of(s, c, scatter) > OPEN)
            mark(v, c, n, of);
    gsl_vector_free(s);
    gsl_matrix_free(v);
}
