/* crossed_requests.c - each of two nodes asks the other one for work. Before it asks it answers a request
 * that has come; while it waits for its own answer it answers nobody.
 *
 * bad outcome: deadlock: both wait in crecv(ANSWER), when the requests cross
 * depth: 2 (node 0 probes < node 1's request comes, node 1 probes < node 0's request comes)      nodes: 2
 * good: the line "both answered"
 * delay: node 1's request by more than 200 us */
#include <stdio.h>
#include "nx.h"
#include "work.h"

enum { ASK = 5, ANSWER = 6, END = 7 };

static void answer(void)
{
    crecv(ASK, NULL, 0);
    csend(ANSWER, NULL, 0, 1 - mynode(), 0);
}

int main(void)
{
    int answered = 0;

    work(mynode() == 0 ? 270 : 5);
    if (iprobe(ASK)) {
        answer();
        answered = 1;
    }
    if (mynode() == 1)
        late(1);
    csend(ASK, NULL, 0, 1 - mynode(), 0);
    crecv(ANSWER, NULL, 0);
    if (!answered)
        answer();
    if (mynode() == 0)
        printf("both answered\n");
    return 0;
}
