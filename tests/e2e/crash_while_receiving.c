/* crash_while_receiving.c N - node 2 crashes while node 0 is in a receive, or between two; N says when. */
#include <stdlib.h>
#include <nx.h>

enum { MESSAGES = 8 };

static void compute(long n)
{
    for (volatile long i = n; i > 0; i--)
        ;
}

int main(int argc, char **argv)
{
    static char part[2000];
    if (mynode() == 0) {
        compute(900);
        flick();
        compute(900);
        flick();
        for (int i = 0; i < MESSAGES; i++)
            crecv(1, part, sizeof part);
    } else if (mynode() == 1) {
        for (int i = 0; i < MESSAGES; i++)
            csend(1, part, 50, 0, 0);
    } else if (mynode() == 2) {
        compute(1720 + atol(argv[1]));
        flick();
        *(volatile char *)16 = 1;
    }
    return 0;
}
