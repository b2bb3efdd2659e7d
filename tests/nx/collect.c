/* gcolx and gcol give every node all nodes' bytes, in the order of the nodes; lengths may be 0.
 * run: -m ipsc860 -n 1
 * run: -m ipsc860 -n 2
 * run: -m ipsc860 -n 3
 * run: -m ipsc860 -n 8
 * run: -m delta -n 33
 */
#include <nx.h>
#include <stdio.h>
#include <string.h>

static char x[1000], y[40000];

static long length(long node)
{
    return node * 37 % 5 * 60; /* 0, 120, 240, 60, 180, 0 ... */
}

static long is_right(long total)
{
    long k, i, at = 0;
    for (k = 0; k < numnodes(); k++)
        for (i = 0; i < length(k); i++)
            if (y[at++] != (char)(k + i))
                return 0;
    return at == total;
}

int main(void)
{
    long i, me = mynode(), wrong = 0, lens[64], total = 0, got = -1, work;
    for (i = 0; i < length(me); i++)
        x[i] = (char)(me + i);
    for (i = 0; i < numnodes(); i++)
        total += lens[i] = length(i);
    gcolx(x, lens, y);
    wrong += !is_right(total);
    memset(y, 0, sizeof y);
    gcol(x, length(me), y, sizeof y, &got);
    wrong += got != total || !is_right(total);
    wrong += _gcol(x, length(me), y, total - 1, &got) != -1 || (total > 0 ? errno != EQBLEN : errno != EQLEN);
    wrong += _gcolx(x, 0, y) != -1 || errno != EQPBUF;
    gisum(&wrong, 1, &work);
    if (me == 0)
        printf("%ld wrong\n", wrong);
    return 0;
}
