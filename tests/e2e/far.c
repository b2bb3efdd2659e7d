/* far.c - computes past a slice boundary without a poll, prints, and computes on or crashes, while others
 * send. */
#include <nx.h>
#include <stdio.h>
static volatile double x;
#define FOUR(a) a a a a
#define MANY(a) FOUR(FOUR(FOUR(FOUR(FOUR(a)))))
int main(int argc, char **argv)
{
    long i = 0;
    if (mynode() == 0) {
        MANY(x = x / 1.5 + 1;)
        printf("printed\n");
        if (argc > 1)
            *(volatile int *)8 = 1;
        for (;;)
            x = x * 0.5 + 1;
    }
    for (;;)
        csend(1, &i, sizeof i, mynode() % 2 + 1, 0), crecv(1, &i, sizeof i);
}
