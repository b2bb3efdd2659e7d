/* lost_interrupt.c - a handler never runs again, because a way out of a critical section leaves it masked.
 *
 *    nxcc -g -O2 -o lost_interrupt lost_interrupt.c
 *    touchstone run -n 4 lost_interrupt      goes well
 *    touchstone run -n 2 lost_interrupt      does not
 *
 * Node 0 computes, and serves the others between two rounds. A handler puts their requests into a queue,
 * and the main program takes them out. Both use the queue, so the main program masks handlers while it
 * does: masktrap(1) ... masktrap(0). But when the queue is empty, take() returns without masktrap(0). The
 * handler that would add the next request is due, and masked for ever. The main program waits for the
 * handler, and the other nodes wait for their answers.
 *
 * With several nodes the queue is never empty when the main program looks, and nobody notices.
 *
 * The remedy: one way out, or masktrap(0) before each return. */
#include <stdio.h>
#include <nx.h>

enum { REQUEST = 1, ANSWER, WAKE, REQUESTS = 5, ROOM = 128, THINK = 1500, ROUND = 1000 };

static long queue[ROOM], put, taken, waiting;

static void on_request(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)pid;
    queue[put++ % ROOM] = node;
    hrecv(REQUEST, NULL, 0, on_request);
    if (waiting)
        csend(WAKE, NULL, 0, mynode(), 0);
    waiting = 0;
}

static void compute(int points)
{
    static double field[THINK + ROUND];
    int i;

    for (i = 1; i < points; i++)
        field[i] = 0.5 * (field[i - 1] + field[i] + 1);
}

/* The node that has asked, or -1: none. */
static long take(void)
{
    long node;

    masktrap(1);
    if (put == taken) {
        waiting = 1;
        return -1; /* and handlers stay masked */
    }
    node = queue[taken++ % ROOM];
    masktrap(0);
    return node;
}

static void serve(long requests)
{
    hrecv(REQUEST, NULL, 0, on_request);
    compute(THINK + ROUND); /* by then all have asked */
    while (requests > 0) {
        long node = take();

        if (node < 0) {
            crecv(WAKE, NULL, 0); /* until a handler has put a request into the queue */
            continue;
        }
        csend(ANSWER, NULL, 0, node, 0);
        requests--;
        compute(ROUND);
    }
}

int main(void)
{
    int i;

    if (mynode() == 0)
        serve(REQUESTS * (numnodes() - 1));
    for (i = 0; mynode() > 0 && i < REQUESTS; i++) {
        compute(THINK);
        csend(REQUEST, NULL, 0, 0, 0);
        crecv(ANSWER, NULL, 0);
    }
    if (mynode() == 0)
        printf("%ld requests served\n", REQUESTS * (numnodes() - 1));
    return 0;
}
