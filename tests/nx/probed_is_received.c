/* A probe and the receive of the same kind behind it take the same message, whatever comes in between; and
 * one sender's messages of one type are found in the order sent, although short ones come whole before long
 * ones that were sent earlier.
 * run: all
 * run: -m paragon -n 8
 * run: -m cluster2026 -n 8
 */
#include "rule.h"
#include <stdlib.h>

enum { EACH = 60, MOST = 9000, TYPES = 2 };
static long out[MOST / sizeof(long)], in[MOST / sizeof(long)], last[TYPES][128];
static int others, in_order = 1;
static unsigned long random_state;

static long random_below(long n)
{
    random_state = (random_state * 1103515245 + 12345) & 0x7fffffff;
    return (long)(random_state >> 16) % n;
}

/* Empty, short, long; the first word is its number. */
static void send_one(long number, long node)
{
    static const long lengths[] = {8, 8, 60, 101, 900, MOST};
    long type = random_below(TYPES);
    out[0] = number * TYPES + type;
    csend(type, out, lengths[random_below(6)], node, 0);
}

/* Of any type, or of one, or of a mask. */
static long typesel_for(long count)
{
    return count % 3 == 0 ? -1 : count % 3 == 1 ? random_below(TYPES) : (long)0x80000003;
}

static void take(long typesel)
{
    long count = infocount(), node = infonode(), type = infotype();
    crecv(typesel, in, count);
    others += infocount() != count || infonode() != node || infotype() != type;
    in_order = in_order && in[0] > last[type][node];
    last[type][node] = in[0];
}

int main(void)
{
    long got = 0, want = EACH * (numnodes() - 1), sent = 0;
    random_state = 77 + 31 * (unsigned long)mynode();
    while (sent < EACH || got < want) {
        long typesel = typesel_for(got);
        if (sent < EACH) {
            sent++;
            for (long node = 0; node < numnodes(); node++)
                if (node != mynode())
                    send_one(sent, node);
        }
        for (int tries = 0; tries < 10 && got < want; tries++)
            if (iprobe(typesel)) {
                take(typesel);
                got++;
            }
        if (sent == EACH && got < want) {
            cprobe(-1);
            take(-1);
            got++;
        }
    }
    rule("a receive takes what the probe before it found", others == 0);
    rule("one sender's of one type are found in the order sent", in_order);
    return 0;
}
