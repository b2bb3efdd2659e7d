/* two_exchanges.c - node 0 receives the keys of three nodes in any order and sorts them by exchanging
 * neighbours. It stops after two exchanges, which are enough for all orders but one.
 *
 * bad outcome: wrong output, when the keys come in the order 3, 2, 1, which takes three exchanges
 * depth: 2 (3 < 2, 2 < 1)      nodes: 4
 * good: the line "1 2 3"
 * delay: node 1's message by more than 240 us, and node 2's by more than 120 us, but less than node 1's */
#include <stdio.h>
#include "nx.h"
#include "work.h"

enum { KEY = 5, KEYS = 3, EXCHANGES = 2 };

/* The first key that is greater than the next one; KEYS - 1: there is none. */
static int out_of_order(const long *key)
{
    int i = 0;

    while (i < KEYS - 1 && key[i] <= key[i + 1])
        i++;
    return i;
}

static void sort(long *key)
{
    int n, i;

    for (n = 0; n < EXCHANGES && (i = out_of_order(key)) < KEYS - 1; n++) {
        long k = key[i];

        key[i] = key[i + 1];
        key[i + 1] = k;
    }
}

int main(void)
{
    long me = mynode(), key[KEYS];
    int i;

    if (me == 0) {
        for (i = 0; i < KEYS; i++)
            crecv(KEY, &key[i], sizeof key[i]);
        sort(key);
        printf("%ld %ld %ld\n", key[0], key[1], key[2]);
    } else {
        work(120 * (me - 1));
        late(KEYS - me);
        csend(KEY, &me, sizeof me, 0, 0);
    }
    return 0;
}
