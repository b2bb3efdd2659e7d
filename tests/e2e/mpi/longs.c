/* longs.c - messages of all lengths, short and long, in all directions at once. Each node sends as many messages to each other
 * node as the argument says, while it receives as many from each in various ways. Every byte is checked; and the order of the
 * messages between two nodes. */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 300000, NODES = 8, LOST = 900, KEPT = 910 };
static unsigned char out[MOST], in[MOST], boxes[NODES][MOST];
static long me, nodes, messages, wrong, expected[NODES], ids[NODES];
static volatile long handled;

/* Some fit into a packet, or into a few; some just do not. */
static long length_of(long from, long to, long i)
{
    static const long lengths[] = {0, 8, 4000, 4001, 7999, 8000, 16384, 20000, 20001, 70000, MOST};
    return lengths[(from * 7 + to * 3 + i * 5) % 11];
}

static unsigned char byte_of(long from, long to, long i, long at)
{
    return (unsigned char)(from * 31 + to * 17 + i * 7 + at / 64);
}

/* Types are the senders' numbers. */
static void send(long to, long i)
{
    long length = length_of(me, to, i);
    for (long at = 0; at < length; at++)
        out[at] = byte_of(me, to, i, at);
    csend(me, out, length, to, 0);
    memset(out, 255, (size_t)length); /* the message is a copy */
}

static void check(const unsigned char *bytes, long count, long from)
{
    long i = expected[from]++;
    wrong += count != length_of(from, me, i);
    for (long at = 0; at < count; at++)
        wrong += bytes[at] != byte_of(from, me, i, at);
}

static void handler(long type, long count, long node, long pid)
{
    (void)type, (void)pid;
    check(boxes[node], count, node);
    handled++;
}

static void receive(long from, long i)
{
    switch (i % 5) {
    case 0:
        crecv(from, in, MOST);
        check(in, infocount(), infonode());
        break;
    case 1:
        cprobe(from);
        crecv(from, in, infocount());
        check(in, infocount(), infonode());
        break;
    case 2:
        ids[0] = irecv(from, in, MOST);
        iprobe(-1);
        msgwait(ids[0]);
        check(in, infocount(), infonode());
        break;
    case 3:
        handled = 0;
        hrecv(from, boxes[from], MOST, handler);
        while (!handled)
            ;
        break;
    default: /* the receive is withdrawn, perhaps with its message, and made again */
        ids[0] = irecv(from, in, MOST);
        iprobe(-1);
        msgcancel(ids[0]);
        memset(in, 98, MOST);
        crecvx(from, in, MOST, from, -1, msginfo);
        check(in, msginfo[1], from);
    }
}

/* All send at once: each message meets one in the other direction. */
static void exchange(void)
{
    for (long i = 0; i < messages; i++)
        for (long k = 1; k < nodes; k++) {
            long from = (me + nodes - k) % nodes, to = (me + k) % nodes;
            send(to, i);
            if (i % 3 != 2) /* sometimes messages pile up */
                receive(from, expected[from]);
        }
    for (long from = 0; from < nodes; from++)
        while (from != me && expected[from] < messages)
            receive(from, expected[from]);
}

/* Long messages that nobody receives, thrown away in time or at the end; and one to all. */
static void lose(void)
{
    csend(LOST, out, MOST, (me + 1) % nodes, 0);
    gsync();
    cprobe(LOST);
    flushmsg(LOST, me, 0);
    wrong += iprobe(LOST) != 0;
    gsync();
    if (me == 0) {
        memset(out, 5, MOST);
        csend(LOST + 1, out, MOST, -1, 0);
    } else {
        crecv(LOST + 1, in, MOST);
        wrong += in[0] != 5 || in[MOST - 1] != 5;
    }
    csend(LOST + 2, out, MOST, (me + 1) % nodes, 0);
}

/* A receive is withdrawn when its message has come, perhaps into its buffer. Another receive gets the message. */
static void withdraw(void)
{
    static const long lengths[] = {8, 8000, 20000, 70000};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        if (me == 0) {
            long id = irecv(KEPT, in, MOST);
            csend(KEPT + 1, NULL, 0, 1, 0);
            crecv(KEPT + 2, NULL, 0);
            msgcancel(id);
            memset(in, 99, MOST);
            crecv(KEPT, boxes[0], MOST);
            wrong += infocount() != lengths[i] || boxes[0][0] != 7 || boxes[0][lengths[i] - 1] != 7;
        } else if (me == 1) {
            crecv(KEPT + 1, NULL, 0);
            memset(out, 7, MOST);
            csend(KEPT, out, lengths[i], 0, 0);
            csend(KEPT + 2, NULL, 0, 0, 0);
        }
    }
}

int main(int argc, char **argv)
{
    long work;
    me = mynode(), nodes = numnodes();
    messages = argc > 1 ? atol(argv[1]) : 9;
    exchange();
    lose();
    withdraw();
    gisum(&wrong, 1, &work);
    if (me == 0)
        printf("%ld wrong\n", wrong);
    return 0;
}
