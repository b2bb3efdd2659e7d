/* cluster.c - NX on MPI against plain MPI: times of the same patterns of messages, both in one program, by
 * turns.
 *
 *     mpirun -np N cluster            a line for each pattern: name, bytes, microseconds of a round on plain
 *                                     MPI and on NX, and the ratio
 *     mpirun -np 2 cluster handlers   how long a message waits for its handler, which interrupts a computing
 *                                     node, one in sleep, and one in usleep; and how late the system ends a
 *                                     pause of a plain program: median and 99th percentile, microseconds
 *
 * A turn takes less than a millisecond, and each kind has TURNS turns. A figure is the 2nd percentile of its
 * turns: other programs of the computer only lengthen turns, and leave some alone if they are short. On a
 * quiet computer it is close to the median.
 */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <time.h>
#include <unistd.h>
#include "plain.h"

enum { TURNS = 301, LOW = 2, LARGEST = 1 << 20 };

static long me, nodes;
static char out[2 * LARGEST], in[2 * LARGEST];

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* --- the patterns in NX --- */

static void ping_pong(int bytes, int rounds)
{
    for (int i = 0; i < rounds && me < 2; i++) {
        if (me == 0)
            csend(1, out, bytes, 1, 0);
        crecv(1, in, bytes);
        if (me == 1)
            csend(1, out, bytes, 0, 0);
    }
}

static void halo(int bytes, int rounds)
{
    long left = (me + nodes - 1) % nodes, right = (me + 1) % nodes;
    for (int i = 0; i < rounds; i++) {
        long from_left = irecv(2, in, bytes), from_right = irecv(3, in + bytes, bytes);
        csend(2, out, bytes, right, 0);
        csend(3, out + bytes, bytes, left, 0);
        msgwait(from_left);
        msgwait(from_right);
    }
}

static void sum(int bytes, int rounds)
{
    for (int i = 0; i < rounds; i++)
        gdsum((double *)out, bytes / (long)sizeof(double), (double *)in);
}

static void barrier(int bytes, int rounds)
{
    (void)bytes;
    for (int i = 0; i < rounds; i++)
        gsync();
}

/* --- the patterns in plain MPI --- */

static void ping_pong_plain(int bytes, int rounds)
{
    plain_ping_pong(out, in, bytes, rounds);
}

static void halo_plain(int bytes, int rounds)
{
    plain_halo(out, in, bytes, rounds);
}

static void sum_plain(int bytes, int rounds)
{
    plain_sum((double *)out, (double *)in, bytes / (int)sizeof(double), rounds);
}

static void barrier_plain(int bytes, int rounds)
{
    (void)bytes;
    plain_barrier(rounds);
}

/* --- turns --- */

static const struct pattern {
    const char *name;
    int bytes, rounds;
    void (*plain)(int bytes, int rounds), (*nx)(int bytes, int rounds);
} patterns[] = {
    {"ping-pong", 8, 300, ping_pong_plain, ping_pong},
    {"ping-pong", 1024, 300, ping_pong_plain, ping_pong},
    {"ping-pong", 16384, 50, ping_pong_plain, ping_pong},
    {"ping-pong", 65536, 30, ping_pong_plain, ping_pong},
    {"ping-pong", 1 << 20, 3, ping_pong_plain, ping_pong},
    {"halo", 1024, 200, halo_plain, halo},
    {"halo", 8192, 60, halo_plain, halo},
    {"halo", 65536, 20, halo_plain, halo},
    {"halo", 1048576, 5, halo_plain, halo},
    {"gdsum", 8, 300, sum_plain, sum},
    {"gdsum", 8000, 100, sum_plain, sum},
    {"gdsum", 32000, 40, sum_plain, sum},
    {"gdsum", 1 << 20, 2, sum_plain, sum},
    {"gsync", 0, 300, barrier_plain, barrier},
};

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double percentile(double *x, int count, int percent)
{
    qsort(x, (size_t)count, sizeof *x, ascending);
    return x[(count - 1) * percent / 100];
}

/* Microseconds of a round. */
static double timed(void (*run)(int bytes, int rounds), const struct pattern *p)
{
    plain_barrier(1);
    double begin = now();
    run(p->bytes, p->rounds);
    plain_barrier(1);
    return (now() - begin) / p->rounds * 1e6;
}

static void compare(const struct pattern *p)
{
    static double plain[TURNS], nx[TURNS];
    memset(out, 0, sizeof out);        /* sums of zeros stay finite */
    for (int i = -1; i < TURNS; i++) { /* the first turn is not counted */
        double a = timed(p->plain, p), b = timed(p->nx, p);
        if (i >= 0)
            plain[i] = a, nx[i] = b;
    }
    double a = percentile(plain, TURNS, LOW), b = percentile(nx, TURNS, LOW);
    if (me == 0)
        printf("%-10s %8d %9.2f %9.2f %6.2f\n", p->name, p->bytes, a, b, b / a);
}

/* --- handlers --- */

enum { MESSAGES = 2000, ASLEEP = 300 };
static double sent, waits[MESSAGES];
static volatile long handled;

static void handler(long type, long count, long node, long pid)
{
    (void)count, (void)pid;
    waits[handled++] = (now() - sent) * 1e6;
    hrecv(type, (char *)&sent, sizeof sent, handler);
    csend(6, out, 0, node, 0);
}

/* Node 1 sends at random moments; clocks of one computer agree. */
static void send_at_times(int count)
{
    for (int i = 0; i < count; i++) {
        double until = now() + 1e-6 * (100 + rand() % 400);
        while (now() < until)
            ;
        double time = now();
        csend(5, (char *)&time, sizeof time, 0, 0);
        crecv(6, in, 0);
    }
}

static void compute(void)
{
    volatile double x = 1;
    for (int i = 0; i < 1000; i++)
        x = x * 1.0000001;
}

static void nap(void)
{
    usleep(100000);
}

static void doze(void)
{
    sleep(1);
}

static void tell(const char *what, int count)
{
    double middle = percentile(waits, count, 50);
    printf("%-10s %9.1f %9.1f\n", what, middle, percentile(waits, count, 99));
}

static void handlers_during(const char *what, void (*run)(void), int count)
{
    handled = 0;
    gsync();
    if (me == 1)
        send_at_times(count);
    while (me == 0 && handled < count)
        run();
    if (me == 0)
        tell(what, count);
}

/* What no program can better that is woken by the system. */
static void plain_pauses(int count)
{
    prctl(PR_SET_TIMERSLACK, 1);
    for (int i = 0; i < count; i++) {
        const struct timespec pause = {.tv_nsec = 100000 + rand() % 400000};
        double begin = now();
        nanosleep(&pause, NULL);
        waits[i] = (now() - begin) * 1e6 - 1e-3 * (double)pause.tv_nsec;
    }
    tell("nanosleep", count);
}

int main(int argc, char **argv)
{
    me = mynode(), nodes = numnodes();
    plain_begin();
    if (argc > 1 && strcmp(argv[1], "handlers") == 0) {
        if (me == 0)
            hrecv(5, (char *)&sent, sizeof sent, handler);
        handlers_during("computing", compute, MESSAGES);
        handlers_during("usleep", nap, ASLEEP);
        handlers_during("sleep", doze, ASLEEP);
        if (me == 0)
            plain_pauses(ASLEEP);
        return 0;
    }
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++)
        if (argc < 2 || strcmp(argv[1], patterns[i].name) == 0)
            compare(&patterns[i]);
    return 0;
}
