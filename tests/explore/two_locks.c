/* two_locks.c - nodes 2 and 3 serve a lock each. Node 0 takes lock 2 and then lock 3, node 1 takes lock 3
 * and then lock 2.
 *
 * bad outcome: deadlock: each client has one lock and waits for the other (all four nodes wait)
 * depth: 2 (node 0 gets lock 2 < node 1's request for it, node 1 gets lock 3 < node 0's request for it)
 * nodes: 4
 * good: the line "both had both", from each of the clients
 * delay: node 0's second request, or the grant before it, by more than 190 us */
#include <stdio.h>
#include "nx.h"
#include "work.h"

enum { TAKE = 5, GIVE_BACK = 6, GRANTED = 7, CLIENTS = 2 };

static void serve(void)
{
    long holder = -1, next = -1;
    int given_back = 0;

    while (given_back < CLIENTS) {
        crecv(-1, NULL, 0);
        if (infotype() == GIVE_BACK) {
            given_back++;
            holder = next, next = -1;
        } else if (holder >= 0) {
            next = infonode();
            continue;
        } else {
            holder = infonode();
        }
        if (holder >= 0)
            csend(GRANTED, NULL, 0, holder, 0);
    }
}

static void take(long lock)
{
    csend(TAKE, NULL, 0, lock, 0);
    crecv(GRANTED, NULL, 0);
}

int main(void)
{
    long me = mynode();

    if (me >= CLIENTS) {
        serve();
        return 0;
    }
    work(350 * me);
    take(2 + me);
    if (me == 0)
        late(1);
    take(3 - me);
    csend(GIVE_BACK, NULL, 0, 2, 0);
    csend(GIVE_BACK, NULL, 0, 3, 0);
    printf("both had both\n");
    return 0;
}
