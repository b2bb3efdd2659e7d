/* A message to node -1 reaches every other node once, whole, with the sender's number, from any sender and on
 * any number of nodes; and the sender's later message of the same type does not overtake it.
 * run: -m ipsc860 -n 16
 * run: -m delta -n 1
 * run: -m delta -n 12
 * run: -m delta -n 33
 */
#include <nx.h>
#include <stdio.h>
#include <string.h>

enum { TYPE = 7, AFTER = 1 };
static const long lengths[] = {0, 100, 101, 5000};
static char buf[5000];
static long wrong;

/* One message to all and a short one behind it; every third node receives late. */
static void round_of(long root, long length)
{
    char mark = (char)(root + length);
    if (mynode() == root) {
        memset(buf, mark, sizeof buf);
        csend(TYPE, buf, length, -1, 0);
        for (long node = 0; node < numnodes(); node++)
            if (node != root)
                csend(TYPE, &mark, AFTER, node, 0);
        return;
    }
    if (mynode() % 3 == 0)
        cprobe(TYPE);
    memset(buf, 0, sizeof buf);
    crecv(TYPE, buf, sizeof buf);
    wrong += infonode() != root || infocount() != length || (length && buf[length - 1] != mark);
    crecv(TYPE, buf, sizeof buf);
    wrong += infonode() != root || infocount() != AFTER;
}

int main(void)
{
    long work;
    for (long root = 0; root < numnodes(); root += 3) {
        for (int i = 0; i < 4; i++)
            round_of(root, lengths[i]);
        gsync();
    }
    wrong += iprobe(-1);
    gisum(&wrong, 1, &work);
    if (mynode() == 0)
        printf("%ld wrong\n", wrong);
    return 0;
}
