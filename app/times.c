/* times.c - seconds by activity and by layer; see times.h. */
#include <stdio.h>
#include <string.h>
#include <nx.h>
#include "fail.h"
#include "times.h"

/* The figures of a layer, in the order in which they are printed. */
enum { START, TOTAL, READ, HELPED, SERVED, PACKED, WAITED, FIGURES };

static struct {
    int on, layers, layer;      /* layer: the open one, or -1 */
    volatile enum activity now; /* a handler puts back what it has found */
    double begin, last, end;
    double spent[ACTIVITIES];
    double opened_at, before[ACTIVITIES]; /* of the open layer: when, and spent until then */
    double (*of_layer)[FIGURES];
} times;

void times_begin(int on, double now, int layers)
{
    times.on = on;
    if (!on)
        return;
    times.layers = layers;
    times.layer = -1;
    times.of_layer = allocate(layers * sizeof *times.of_layer);
    memset(times.of_layer, 0, layers * sizeof *times.of_layer);
    times.begin = times.last = now;
}

static void stamp(void)
{
    double now = dclock();

    times.spent[times.now] += now - times.last;
    times.last = now;
}

enum activity times_enter(enum activity a)
{
    enum activity before = times.now;

    if (times.on) {
        long old = masktrap(1);

        stamp();
        times.now = a;
        masktrap(old);
    } else {
        times.now = a;
    }
    return before;
}

enum activity times_now(void)
{
    return times.now;
}

static double since_opened(enum activity a)
{
    return times.spent[a] - times.before[a];
}

static void close_layer(void)
{
    double *f = times.of_layer[times.layer];

    f[START] = times.opened_at - times.begin;
    f[TOTAL] = times.last - times.opened_at;
    f[READ] = since_opened(READING);
    f[HELPED] = since_opened(HELPING);
    f[SERVED] = since_opened(ANSWERING) + since_opened(COLLECTING) + since_opened(NEWS);
    f[PACKED] = since_opened(PACKING);
    f[WAITED] = since_opened(WAIT_REQUESTS);
}

void times_layer(int layer)
{
    if (!times.on)
        return;
    masktrap(1);
    stamp();
    if (times.layer >= 0)
        close_layer();
    times.layer = layer;
    times.opened_at = times.last;
    memcpy(times.before, times.spent, sizeof times.before);
    masktrap(0);
}

void times_end(void)
{
    if (!times.on)
        return;
    masktrap(1);
    times_enter(OTHER);
    times.end = times.last;
    masktrap(0);
}

/* Sums over the nodes of a class: how many, when they began and ended, their seconds by activity. */
enum { NODES, BEGAN, ENDED, SPENT, SUMS = SPENT + ACTIVITIES };

static void print_class(const char *name, const double *sum)
{
    static const char *const names[ACTIVITIES] = {
        "other",      "reading", "helping", "computing",     "sending",     "answering",  "packing",
        "collecting", "news",    "dealing", "wait_requests", "wait_slaves", "wait_chunk", "wait_order"};
    int a;

    printf("times_%s_nodes %.0f\n", name, sum[NODES]);
    printf("times_%s_began_s %.9f\ntimes_%s_ended_s %.9f\n", name, sum[BEGAN], name, sum[ENDED]);
    for (a = 0; a < ACTIVITIES; a++)
        printf("times_%s_%s_s %.9f\n", name, names[a], sum[SPENT + a]);
}

/* One line a layer: when it was opened, its seconds, and the seconds of reading, helping, serving slaves,
 * packing and waiting. */
static void print_layers(void)
{
    int i, k;

    for (i = 0; i < times.layers; i++) {
        if (times.of_layer[i][TOTAL] == 0)
            continue;
        printf("times_layer_%d %ld", i, mynode());
        for (k = 0; k < FIGURES; k++)
            printf(" %.6f", times.of_layer[i][k]);
        printf("\n");
    }
}

void times_print(int is_host)
{
    double sum[2][SUMS], work[2 * SUMS];
    double *mine = sum[is_host];

    if (!times.on)
        return;
    memset(sum, 0, sizeof sum);
    mine[NODES] = 1;
    mine[BEGAN] = times.begin;
    mine[ENDED] = times.end;
    masktrap(1);
    memcpy(mine + SPENT, times.spent, sizeof times.spent);
    masktrap(0);
    gdsum(&sum[0][0], 2 * SUMS, work);
    masktrap(1);
    if (mynode() == 0) {
        print_class("hosts", sum[1]);
        print_class("slaves", sum[0]);
    }
    if (is_host)
        print_layers();
    fflush(stdout);
    masktrap(0);
}
