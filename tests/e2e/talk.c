/* talk.c - talk SEED ROUNDS [LATER]: after LATER microseconds, in each round the nodes send each other a
 * random pattern of messages, short, long and forced, and receive them in various ways: with a receive posted
 * before or after, waited for in another order than sent, or by any type. With an odd seed node 0 has a
 * handler for other messages. With -DFLUSHES the program has flushmsg, which it never calls: then no call of
 * the program is deferred. */
#include <stdlib.h>
#include <unistd.h>
#include "nx.h"

enum { MOST = 24, FORCED = 1 << 30, LONGEST = 4000 };

static struct {
    long from, to, type, bytes, id;
    int way; /* of receiving */
} message[MOST];
static char out[LONGEST], in[MOST][LONGEST];
static volatile double sum;
static unsigned long state;

#ifdef FLUSHES
void never(void)
{
    flushmsg(-1, -1, -1);
}
#endif

static long any(long below)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (long)((state >> 33) % (unsigned long)below);
}

static void compute(long turns)
{
    for (long i = 0; i < turns; i++)
        sum += (double)i;
}

/* The same on all nodes. */
static long agree(long nodes)
{
    static const long sizes[] = {0, 8, 60, 90, 100, 101, 700, 2500, LONGEST};
    long count = 1 + any(MOST);
    for (long i = 0; i < count; i++) {
        message[i].from = any(nodes);
        message[i].to = (message[i].from + 1 + any(nodes - 1)) % nodes;
        message[i].bytes = sizes[any(9)];
        message[i].way = (int)any(4);
        message[i].type = any(5) ? 10 + i : FORCED + i;
    }
    return count;
}

/* For messages to node 0 that no round has agreed upon. */
enum { CALL = 5 };

static void called(long type, long count, long node, long pid)
{
    static char buffer[LONGEST];
    (void)type, (void)pid;
    compute(node + count % 7);
    hrecv(CALL, buffer, sizeof buffer, called);
}

static void post(long i)
{
    message[i].id = irecv(message[i].type, in[i], LONGEST);
}

static void receive(long i, long me)
{
    if (message[i].to != me)
        return;
    if (message[i].type < FORCED && message[i].way == 1)
        crecv(message[i].type, in[i], LONGEST);
    else
        msgwait(message[i].id);
}

static void round_of(long me, long nodes, unsigned long seed)
{
    long count = agree(nodes), sent = 0, id[MOST];
    for (long i = 0; i < count; i++)
        if (message[i].to == me && (message[i].type >= FORCED || message[i].way == 0))
            post(i);
    gsync();
    state = seed + (unsigned long)me; /* from here on each node has its own */
    compute(any(200));
    for (long i = 0; i < count; i++) {
        if (message[i].to == me && message[i].type < FORCED && message[i].way > 1)
            post(i);
        if (message[i].from == me && any(3))
            csend(message[i].type, out, message[i].bytes, message[i].to, 0);
        else if (message[i].from == me)
            id[sent++] = isend(message[i].type, out, message[i].bytes, message[i].to, 0);
        if (!any(3))
            compute(any(100));
        if (me > 0 && seed % 2 && !any(6))
            csend(CALL, out, any(2) ? 16 : 3000, 0, 0);
    }
    for (long i = 0; i < count; i++)
        receive(me % 2 ? i : count - 1 - i, me);
    while (sent)
        msgwait(id[--sent]);
}

int main(int argc, char **argv)
{
    if (argc < 3)
        return 64;
    if (atol(argv[1]) % 2 && mynode() == 0)
        called(CALL, 0, 0, 0);
    if (argc > 3) {
        sleep((unsigned)(atol(argv[3]) / 1000000));
        usleep((useconds_t)(atol(argv[3]) % 1000000));
    }
    for (long i = 0; i < atol(argv[2]); i++) {
        unsigned long seed = (unsigned long)(atol(argv[1]) * 1001 + 2 * i);
        state = seed;
        round_of(mynode(), numnodes(), seed * 77);
    }
    return 0;
}
