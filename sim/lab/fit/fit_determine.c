/* fit_determine.c - the numbers that the residuals determine; see fit_determine.h. */
#include "lab/fit/fit_determine.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

/* LAPACK's singular values, and V', of a matrix by columns, which is overwritten. The last two arguments are
 * the lengths of texts that Fortran passes. */
void dgesvd_(const char *jobu, const char *jobvt, const int *rows, const int *columns, double *a,
             const int *lda, double *s, double *u, const int *ldu, double *vt, const int *ldvt, double *work,
             const int *lwork, int *info, size_t, size_t);

/* Singular values below this part of the largest count as 0: slopes are differences of times that are exact
 * to 1e-12. */
static const double NOTHING = 1e-9;
/* A number with a standard error above this part of its range is open. */
static const double OPEN = 0.25;
/* A number belongs to a combination if its share is at least this. */
static const double SHARE = 0.1;

/* Slopes as combinations of numbers: slope = U S V'. */
struct combinations {
    size_t n;
    double *singular; /* of each combination, the largest first */
    double *vt;       /* by columns: the combinations are its rows */
};

/* The share that number k has in combination c. */
static double share(const struct combinations *by, size_t c, size_t k)
{
    return by->vt[k * by->n + c];
}

static bool all_known(const double slope[], size_t n)
{
    for (size_t k = 0; k < n; k++)
        if (isnan(slope[k]))
            return false;
    return true;
}

/* Rows of zeros, which determine nothing, stand for residuals whose slopes are not all known, and for those
 * that are missing if there are fewer than numbers. */
static struct combinations decompose(const double slope[], size_t residuals, size_t n)
{
    struct combinations by = {n, xcalloc(n, sizeof(double)), xcalloc(n * n, sizeof(double))};
    size_t padded = residuals > n ? residuals : n;
    double *a = xcalloc(padded * n, sizeof *a);
    for (size_t i = 0; i < residuals; i++)
        for (size_t k = 0; k < n && all_known(&slope[i * n], n); k++)
            a[k * padded + i] = slope[i * n + k];
    int rows = (int)padded, columns = (int)n, none = 1, room = 8 * (rows + columns), info;
    double *work = xcalloc((size_t)room, sizeof *work);
    dgesvd_("N", "A", &rows, &columns, a, &rows, by.singular, NULL, &none, by.vt, &columns, work, &room,
            &info, 1, 1);
    assert(info == 0);
    free(work);
    free(a);
    return by;
}

/* Has number k an influence, or may it have one, where a slope is not known? */
static bool has_influence(const double slope[], size_t rows, size_t n, size_t k)
{
    for (size_t i = 0; i < rows; i++)
        if (slope[i * n + k] != 0)
            return true;
    return false;
}

/* The standard error of combination c. */
static double error_of(const struct combinations *by, size_t c, double scatter)
{
    double singular = by->singular[c];
    return singular > NOTHING * by->singular[0] ? scatter / singular : INFINITY;
}

/* Marks each number of combination c, which is open. */
static void mark(const struct combinations *by, size_t c, struct fit_number of[])
{
    size_t n = by->n;
    for (size_t k = 0; k < n; k++)
        for (size_t other = 0; other < n; other++) {
            double own = share(by, c, k), its = share(by, c, other);
            if (k == other || own * own < SHARE || its * its < SHARE || of[k].standing == FIT_NO_INFLUENCE ||
                of[other].standing == FIT_NO_INFLUENCE)
                continue;
            of[k].standing = FIT_COMBINED;
            of[k].with[other] = true;
        }
}

void fit_determine(const double slope[], size_t residuals, size_t n, double scatter, struct fit_number of[])
{
    struct combinations by = decompose(slope, residuals, n);
    for (size_t k = 0; k < n; k++) {
        double squares = 0;
        of[k] = (struct fit_number){0};
        for (size_t c = 0; c < n; c++) {
            double part = share(&by, c, k), error = error_of(&by, c, scatter);
            squares += fabs(part) < NOTHING ? 0 : part * part * error * error;
        }
        of[k].error = sqrt(squares);
        if (!has_influence(slope, residuals, n, k))
            of[k] = (struct fit_number){FIT_NO_INFLUENCE, INFINITY, {0}};
        else if (of[k].error > OPEN)
            of[k].standing = FIT_OPEN;
    }
    for (size_t c = 0; c < n; c++)
        if (error_of(&by, c, scatter) > OPEN)
            mark(&by, c, of);
    free(by.singular);
    free(by.vt);
}
