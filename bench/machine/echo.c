/* The echo test: node 0 sends n bytes to a node, which sends them back; half the time of a round, over n and
 * distance.
 *
 *     echo posted NODE:HOPS...    the receive is posted before the message comes, as in the published tests
 *     echo late NODE:HOPS...      the receive is posted when a system buffer holds the message already
 *
 * Each node posts the receive for its next message while the message that it has sent is under way, so that
 * the time measured does not contain the call that posts.
 */
#include <stdlib.h>
#include <string.h>
#include "bench.h"

enum { CONTROL = 1, READY, PING, PONG, ROUNDS = 5, LARGEST = 1 << 20 };

static const long sizes[] = {0,   1,   8,    16,   32,   64,    99,    100,    101,    128,
                             256, 512, 1000, 1024, 4096, 16384, 65536, 262144, 524288, LARGEST};
static char in[LARGEST], out[LARGEST];
static int late;

/* Receives a message: with the receive that was posted under id, or, if late, out of the system buffer. */
static void receive(long id, long type, long bytes)
{
    if (!late) {
        msgwait(id);
        return;
    }
    cprobe(type);
    crecv(type, in, bytes);
}

static long post(long type, long bytes)
{
    return late ? -1 : irecv(type, in, bytes);
}

static void answer(long bytes)
{
    long id = post(PING, bytes);
    csend(READY, NULL, 0, 0, 0);
    for (int i = 0; i < ROUNDS; i++) {
        receive(id, PING, bytes);
        csend(PONG, out, bytes, 0, 0);
        if (i < ROUNDS - 1)
            id = post(PING, bytes);
    }
}

static double one_way_us(long partner, long bytes)
{
    csend(CONTROL, &bytes, sizeof bytes, partner, 0);
    long id = post(PONG, bytes);
    crecv(READY, NULL, 0);
    double begin = now_us();
    for (int i = 0; i < ROUNDS; i++) {
        csend(PING, out, bytes, partner, 0);
        long next = i < ROUNDS - 1 ? post(PONG, bytes) : -1;
        receive(id, PONG, bytes);
        id = next;
    }
    return (now_us() - begin) / (2 * ROUNDS);
}

/* The length at which messages have half the speed of the longest. */
static long half_speed_length(long partner, double longest_us)
{
    double half = LARGEST / longest_us / 2;
    long lo = 1, hi = LARGEST;
    while (lo + 1 < hi) {
        long n = (lo + hi) / 2;
        if ((double)n / one_way_us(partner, n) < half)
            lo = n;
        else
            hi = n;
    }
    return hi;
}

static void measure(long partner, long hops, int figures)
{
    double us[COUNT(sizes)];
    for (int i = 0; i < COUNT(sizes); i++) {
        us[i] = one_way_us(partner, sizes[i]);
        printf("point echo %ld %ld %.6f\n", sizes[i], hops, us[i]);
    }
    if (figures) {
        int last = COUNT(sizes) - 1;
        figure("latency_us", us[0]);
        figure("jump_us", one_way_us(partner, 101) - one_way_us(partner, 100));
        figure("megabytes_per_s", (double)sizes[last] / us[last]);
        figure("us_per_byte", (us[last] - us[last - 1]) / (double)(sizes[last] - sizes[last - 1]));
        figure("half_speed_bytes", (double)half_speed_length(partner, us[last]));
    }
    long end = -1;
    csend(CONTROL, &end, sizeof end, partner, 0);
}

int main(int argc, char **argv)
{
    late = argc > 1 && strcmp(argv[1], "late") == 0;
    for (int i = 2; i < argc; i++) {
        char *colon = strchr(argv[i], ':');
        long partner = atol(argv[i]), bytes;
        if (mynode() == 0)
            measure(partner, colon ? atol(colon + 1) : 1, i == 2);
        if (mynode() != partner)
            continue;
        for (crecv(CONTROL, &bytes, sizeof bytes); bytes >= 0; crecv(CONTROL, &bytes, sizeof bytes))
            answer(bytes);
    }
    return 0;
}
