/* Two neighbours send each other n bytes: time until both have received, over n, in four ways.
 *
 *     posted   both post a receive, tell each other, then send
 *     late     both send, then receive: messages that come first wait in system buffers
 *     forced   as posted, with forced types: eager, without rendezvous
 *     in turn  node 0 sends; node 1 receives, then sends: one direction at a time, for comparison
 */
#include "bench.h"

enum { DATA = 1, SYNC = 2, FORCED = 1 << 30, ROUNDS = 4, LARGEST = 1 << 18 };
enum way { POSTED, LATE, IN_FORCE, IN_TURN, WAYS };

static const char *const names[] = {"posted", "late", "forced", "in_turn"};
static const long sizes[] = {0, 16, 100, 128, 512, 1024, 4096, 16384, 65536, LARGEST};
static char in[LARGEST], out[LARGEST];

/* Both nodes return at nearly one time, within a few microseconds. */
static void agree(long other)
{
    csend(SYNC, NULL, 0, other, 0);
    crecv(SYNC, NULL, 0);
}

static void exchange(enum way way, long bytes, long other)
{
    long type = way == IN_FORCE ? FORCED | DATA : DATA, id = -1;
    if (way == POSTED || way == IN_FORCE)
        id = irecv(type, in, bytes);
    agree(other);
    if (way == IN_TURN && mynode() == 1)
        crecv(type, in, bytes);
    csend(type, out, bytes, other, 0);
    if (id >= 0)
        msgwait(id);
    else if (way == LATE || mynode() == 0)
        crecv(type, in, bytes);
}

static double exchange_us(enum way way, long bytes)
{
    double sum = 0, work;
    for (int i = 0; i < ROUNDS; i++) {
        double begin, end;
        agree(1 - mynode());
        begin = now_us();
        exchange(way, bytes, 1 - mynode());
        end = now_us();
        gdhigh(&end, 1, &work);
        gdlow(&begin, 1, &work);
        sum += end - begin;
    }
    return sum / ROUNDS;
}

int main(void)
{
    double us[WAYS][COUNT(sizes)];
    for (int w = 0; w < WAYS; w++)
        for (int i = 0; i < COUNT(sizes); i++) {
            us[w][i] = exchange_us(w, sizes[i]);
            if (mynode() == 0)
                printf("point %s %ld %.3f\n", names[w], sizes[i], us[w][i]);
        }
    int last = COUNT(sizes) - 1;
    if (mynode() == 0) {
        figure("duplex_gain", us[IN_TURN][last] / us[POSTED][last]);
        figure("late_to_posted", us[LATE][last] / us[POSTED][last]);
        figure("forced_saves_us", us[POSTED][4] - us[IN_FORCE][4]);
    }
    return 0;
}
