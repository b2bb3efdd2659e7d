/* counting.c - the cost of counting: each kernel by gcc, nxcc and nxcc --profile, which alternate in one run.
 *
 * Prints for each kernel
 *  - the ratio time counted / time plain: the median over all rounds, and the least and greatest of the
 *    medians at the places in memory that counting.mk defines;
 *  - the ratio time profiled / time counted;
 *  - the simulated processor's clocks for the kernel, and how many of them take a second of host time;
 *  - the accuracy of interrupts: the longest time from the end of the units to the next poll, in microseconds
 *    of a 40 MHz processor.
 *
 * Results and clocks must be equal at all places.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "nx_api/contract/program_image.h"
#include "kernels.h"

#define DECLARE_AT(place, name)                                                                              \
    double plain_##place##_##name(void), counted_##place##_##name(void), profiled_##place##_##name(void);
#define DECLARE(name) DECLARE_AT(0, name) DECLARE_AT(8, name) DECLARE_AT(24, name) DECLARE_AT(40, name)
KERNELS(DECLARE)

enum { PLACES = 4, ROUNDS = 15 };
static const int64_t budget = 1000000000; /* a preemption every 25 ms of virtual time */
static const double round_seconds = 0.004;

extern struct nxc_image nxc_image;
static const int64_t short_budget = 54321; /* for measuring lateness: about 1.4 us */
static int64_t given, spent, latest;

void nxc_preempt(void)
{
    spent += given - *nxc_image.left;
    if (-*nxc_image.left > latest)
        latest = -*nxc_image.left;
    *nxc_image.left = given;
}

/* What the simulator serves: the paths stay until the end. */
struct nxc_path *nxc_new_path(int64_t counts)
{
    return calloc(1, sizeof(struct nxc_path) + (size_t)counts * sizeof(int64_t));
}

typedef double kernel_fn(void);

struct kernel {
    const char *name;
    kernel_fn *plain[PLACES], *counted[PLACES], *profiled[PLACES];
};

#define ROW(name)                                                                                            \
    {#name,                                                                                                  \
     {plain_0_##name, plain_8_##name, plain_24_##name, plain_40_##name},                                     \
     {counted_0_##name, counted_8_##name, counted_24_##name, counted_40_##name},                             \
     {profiled_0_##name, profiled_8_##name, profiled_24_##name, profiled_40_##name}},
static const struct kernel kernels[] = {KERNELS(ROW)};

static double seconds(kernel_fn *run, int times)
{
    struct timespec a, b;
    clock_gettime(CLOCK_MONOTONIC, &a);
    for (int i = 0; i < times; i++)
        run();
    clock_gettime(CLOCK_MONOTONIC, &b);
    return (double)(b.tv_sec - a.tv_sec) + 1e-9 * (double)(b.tv_nsec - a.tv_nsec);
}

/* The units that run counts if it is preempted after every `each` units. */
static int64_t units_of(kernel_fn *run, int64_t each)
{
    spent = latest = 0;
    *nxc_image.left = given = each;
    run();
    return spent + given - *nxc_image.left;
}

static int rising(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *x, size_t n)
{
    qsort(x, n, sizeof *x, rising);
    return x[n / 2];
}

static void check_equal(const struct kernel *k)
{
    double result = k->plain[0]();
    k->counted[0](); /* the kernel has now prepared what it prepares once */
    for (int p = 0; p < PLACES; p++) {
        k->plain[p]();
        k->counted[p]();
        k->profiled[p]();
        int64_t units = units_of(k->counted[p], budget);
        if (k->plain[p]() == result && k->counted[p]() == result && k->profiled[p]() == result &&
            units == units_of(k->counted[0], short_budget) && units == units_of(k->profiled[p], budget))
            continue;
        fprintf(stderr, "%s: results or counts differ\n", k->name);
        exit(1);
    }
}

/* The times of one kernel: all rounds at all places. */
struct rounds {
    double counted[PLACES * ROUNDS],
        profiled[PLACES * ROUNDS]; /* time counted / plain, and profiled / counted */
    double seconds;                /* of one counted run, the mean */
};

/* Runs plain, counted and profiled kernels alternately; each round begins with another one. */
static void measure_at(const struct kernel *k, int place, struct rounds *r)
{
    kernel_fn *const side[] = {k->plain[place], k->counted[place], k->profiled[place]};
    double once = seconds(k->plain[place], 1), t[3];
    int times = once < round_seconds ? (int)(round_seconds / once) + 1 : 1;
    for (int i = 0; i < ROUNDS; i++) {
        for (int j = i; j < i + 3; j++)
            t[j % 3] = seconds(side[j % 3], times);
        r->counted[place * ROUNDS + i] = t[1] / t[0];
        r->profiled[place * ROUNDS + i] = t[2] / t[1];
        r->seconds += t[1] / times / (PLACES * ROUNDS);
    }
}

/* Prints a kernel's line, and multiplies product[] by its ratios. */
static void measure(const struct kernel *k, double product[2])
{
    struct rounds r = {.seconds = 0};
    double at_place[PLACES];
    check_equal(k);
    *nxc_image.left = given = budget;
    for (int p = 0; p < PLACES; p++)
        measure_at(k, p, &r);
    for (int p = 0; p < PLACES; p++)
        at_place[p] = median(r.counted + p * ROUNDS, ROUNDS);
    double ratio = median(r.counted, PLACES * ROUNDS), profiled = median(r.profiled, PLACES * ROUNDS);
    double clocks = (double)units_of(k->counted[0], short_budget) / NXC_UNITS_PER_CLOCK;
    double late_us = (double)latest / NXC_UNITS_PER_CLOCK / 40;
    qsort(at_place, PLACES, sizeof *at_place, rising);
    printf("%-14s %8.3f   %5.3f-%5.3f %9.3f %12.0f %10.0f %8.2f\n", k->name, ratio, at_place[0],
           at_place[PLACES - 1], profiled, clocks, clocks / r.seconds / 1e6, late_us);
    /* For bench/speed/run; nothing where no such file is open. */
    dprintf(3, "{\"benchmark\": \"counting\", \"kernel\": \"%s\", \"ratio\": %f, \"profiled\": %f}\n",
            k->name, ratio, profiled);
    product[0] *= ratio;
    product[1] *= profiled;
}

int main(void)
{
    double product[2] = {1, 1};
    size_t n = sizeof kernels / sizeof *kernels;
    printf("%-14s %8s   %11s %9s %12s %10s %8s\n", "kernel", "counted/", "at places", "profiled/",
           "i860 clocks", "million", "latest");
    printf("%-14s %8s   %11s %9s %12s %10s %8s\n", "", "plain", "least-most", "counted", "", "a second",
           "us");
    for (size_t i = 0; i < n; i++)
        measure(&kernels[i], product);
    printf("%-14s %8.3f   %11s %9.3f\n", "geometric mean", pow(product[0], 1 / (double)n), "",
           pow(product[1], 1 / (double)n));
    return 0;
}
