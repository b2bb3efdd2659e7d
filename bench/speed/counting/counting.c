/* counting.c - what counting costs: each kernel by gcc and by nxcc, in turn, in one run.
 *
 * Prints for each kernel the median over the rounds of (time counted / time plain) with the middle half's range, and the
 * simulated processor's clocks for the kernel. The results of both sides must be equal.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "nx_api/nxcc/image.h"
#include "kernels.h"

#define DECLARE(name)                                                                                        \
    double plain_##name(void);                                                                               \
    double counted_##name(void);
KERNELS(DECLARE)
APP_KERNELS(DECLARE)

enum { ROUNDS = 41 };
static const int64_t budget = 1000000000; /* a preemption every 25 ms of virtual time */
static const double round_seconds = 0.004;

extern struct nxc_image nxc_image;
static int64_t spent;

void nxc_preempt(void)
{
    spent += budget - *nxc_image.left;
    *nxc_image.left = budget;
}

struct kernel {
    const char *name;
    double (*plain)(void), (*counted)(void);
};

static const struct kernel kernels[] = {
#define ROW(name) {#name, plain_##name, counted_##name},
    KERNELS(ROW) APP_KERNELS(ROW)};

static double seconds(double (*run)(void), int times)
{
    struct timespec a, b;
    clock_gettime(CLOCK_MONOTONIC, &a);
    for (int i = 0; i < times; i++)
        run();
    clock_gettime(CLOCK_MONOTONIC, &b);
    return (double)(b.tv_sec - a.tv_sec) + 1e-9 * (double)(b.tv_nsec - a.tv_nsec);
}

static double clocks_of(double (*run)(void))
{
    spent = 0;
    *nxc_image.left = budget;
    run();
    return (double)(spent + budget - *nxc_image.left) / NXC_UNITS_PER_CLOCK;
}

static int rising(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double measure(const struct kernel *k)
{
    double ratio[ROUNDS], once, clocks;
    int times;
    if (k->plain() != k->counted()) {
        fprintf(stderr, "%s: plain and counted results differ\n", k->name);
        exit(1);
    }
    clocks = clocks_of(k->counted);
    once = seconds(k->plain, 1);
    times = once < round_seconds ? (int)(round_seconds / once) + 1 : 1;
    for (int i = 0; i < ROUNDS; i++) {
        double plain, counted;
        if (i & 1) {
            plain = seconds(k->plain, times);
            counted = seconds(k->counted, times);
        } else {
            counted = seconds(k->counted, times);
            plain = seconds(k->plain, times);
        }
        ratio[i] = counted / plain;
    }
    qsort(ratio, ROUNDS, sizeof *ratio, rising);
    printf("%-14s %8.3f   %5.3f-%5.3f %14.0f\n", k->name, ratio[ROUNDS / 2], ratio[ROUNDS / 4],
           ratio[3 * ROUNDS / 4], clocks);
    return ratio[ROUNDS / 2];
}

int main(void)
{
    double all = 0;
    size_t n = sizeof kernels / sizeof *kernels;
    printf("%-14s %8s   %11s %14s\n", "kernel", "counted/", "middle", "i860 clocks");
    printf("%-14s %8s   %11s %14s\n", "", "plain", "half", "");
    for (size_t i = 0; i < n; i++)
        all += log(measure(&kernels[i]));
    printf("%-14s %8.3f\n", "geometric mean", exp(all / (double)n));
    return 0;
}
