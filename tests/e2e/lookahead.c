/* lookahead.c - lookahead SEED [kill|fail|crash]: all nodes compute with handlers posted, in loops whose trip
 * counts are known at their entry, and send each other short and long messages whose handlers compute and
 * answer. With kill, the last node kills the others while they compute; with fail, it ends with an error;
 * with crash, it crashes while it computes. Each node prints when its handlers ran. */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SMALL = 1, LARGE = 2, ANSWER = 3, ROUNDS = 40, MOST = 20000 };

static char in[4][MOST], out[MOST];
static double row[4000];
static volatile double sum;
static unsigned state, order = 17;
static int handled[4], sent;

static unsigned number(unsigned below)
{
    state = state * 1103515245 + 12345;
    return (state >> 8) % below;
}

static void compute(int n)
{
    for (int i = 0; i < n; i++)
        row[i] = row[i] < 0.5 ? row[i] * 1.5 + 0.1 : row[i] * 0.25;
    double s = 0;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++)
            s += row[i] * k;
    sum = s;
}

/* Rows of one length, which may be 0; and rows that grow. */
static void compute_rows(int rows, int length)
{
    static double cell[64];
    double s = 0;
    for (int y = 0; y < rows; y++)
        for (int x = 0; x < length; x++)
            cell[x] = cell[x] * 0.5 + y;
    for (int y = 0; y < 64; y++) {
        for (int x = 0; x < length; x++)
            s += cell[x] * y;
        for (int x = 0; x <= y; x++)
            s += cell[x];
    }
    sum = s;
}

static void on_message(long type, long count, long node, long pid)
{
    (void)pid;
    order = order * 31 + (unsigned)(node + 1000 * type + count + (long)(dclock() * 1e7));
    handled[type]++;
    compute((int)(count % 300));
    if (type != ANSWER)
        csend(ANSWER, out, count / 4, node, 0);
    hrecv(type, in[type], MOST, on_message);
}

static void has_left(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    order = order * 31 + (unsigned)(dclock() * 1e7);
    sent++;
}

static void send_something(void)
{
    long to = number((unsigned)numnodes());
    if (to == mynode())
        return;
    switch (number(4)) {
    case 0:
        csend(SMALL, out, number(100), to, 0);
        break;
    case 1:
        csend(LARGE, out, 101 + number(MOST - 101), to, 0);
        break;
    case 2:
        hsend(LARGE, out, 101 + number(2000), to, 0, has_left);
        break;
    default:
        masktrap(1);
        compute(1000);
        masktrap(0);
    }
}

int main(int argc, char **argv)
{
    const char *how = argc > 2 ? argv[2] : "";
    long last = numnodes() - 1, i;
    state = (unsigned)(atoi(argv[1]) * 7919 + mynode());
    for (i = SMALL; i <= ANSWER; i++)
        hrecv(i, in[i], MOST, on_message);
    gsync();
    for (i = 0; i < ROUNDS; i++) {
        compute((int)number(4000));
        compute_rows((int)number(number(4) ? 100 : 2000), (int)number(64));
        if (mynode() == last && i == ROUNDS / 2 && !strcmp(how, "crash"))
            *(volatile int *)(number(8) * 8L) = 1;
        if (number(2))
            send_something();
        if (mynode() == last && i == ROUNDS / 2 && !strcmp(how, "fail"))
            exit(3);
        if (mynode() == last && i == ROUNDS / 2 && !strcmp(how, "kill"))
            killcube(-1, -1);
    }
    printf("node %ld: %d %d %d handled, %d sent, order %u, at %.9f s\n", mynode(), handled[1], handled[2],
           handled[3], sent, order, dclock());
    gsync();
    return 0;
}
