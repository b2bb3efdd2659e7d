/* Programs without prototypes pass ints where NX has longs: of an argument only the low 32 bits count, as
 * signed. Here the others are set to something.
 * run: all
 */
#include <stdint.h>
#include <stdio.h>

long csend(), crecv(), isend(), irecv(), msgwait(), msgdone(), cprobe(), iprobe(), csendrecv(), masktrap(),
    gisum(), gihigh();
long gray(), ginv(), infocount(), infotype(), infonode(), mynode(), numnodes(), hrecv(), flushmsg(), gcol(),
    gsync();
static volatile int handled;

/* x with other bits above it. */
static int64_t dirty(int x)
{
    return (int64_t)(0x5aa5000000000000u | (uint32_t)x);
}

static void handler(int type, int count, int node, int pid)
{
    handled = type == 6 && count == 3 && node >= 0 && pid == 0;
}

static void rule(const char *text, int holds)
{
    int64_t broken = !holds, work;
    gisum(&broken, dirty(1), &work);
    if (mynode() == 0 || !holds)
        printf("%s: %s\n", text, broken ? "NO" : "yes");
}

int main(void)
{
    char out[8] = "abcdefg", in[8];
    int me = (int)mynode();
    int64_t id, total;
    static char everybody[200];
    csend(dirty(5), out, dirty(8), dirty(me), dirty(0));
    cprobe(dirty(-1));
    rule("iprobe of -1, any type", iprobe(dirty(-1)) == 1 && infotype() == 5);
    crecv(dirty(5), in, dirty(8));
    rule("csend, crecv", infocount() == 8 && infonode() == me && in[6] == 'g');
    id = irecv(dirty(0x80000000 | 1 << 4), in, dirty(8));
    msgwait(dirty((int)isend(dirty(4), out, dirty(2), dirty(me), dirty(0))));
    while (!msgdone(dirty((int)id)))
        ;
    rule("a mask; ids", infotype() == 4 && infocount() == 2);
    hrecv(dirty(6), in, dirty(8), handler);
    csend(dirty(6), out, dirty(3), dirty(me), dirty(0));
    while (!handled)
        iprobe(dirty(-1));
    rule("a handler that takes ints", handled);
    rule("csendrecv", csendrecv(dirty(7), out, dirty(4), dirty(me), dirty(0), dirty(7), in, dirty(8)) == 4);
    csend(dirty(8), out, dirty(1), dirty(-1), dirty(0));
    gsync();
    cprobe(dirty(numnodes() > 1 ? 8 : (csend(dirty(8), out, dirty(1), dirty(me), dirty(0)), 8)));
    flushmsg(dirty(8), dirty(me), dirty(0));
    rule("-1 as all others; flushmsg", iprobe(dirty(8)) == 0);
    rule("masktrap", masktrap(dirty(0)) == 0);
    rule("gray and ginv", gray(dirty(5)) == 7 && ginv(dirty(7)) == 5);
    gcol(out, dirty(1), everybody, dirty(200), &total);
    rule("gcol", total == numnodes() && everybody[total - 1] == 'a');
    return 0;
}
