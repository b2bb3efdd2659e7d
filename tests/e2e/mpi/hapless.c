/* Node 0 hears from the others in an order that depends on time, and then waits for ever, errs, or
 * crashes. */
#include <nx.h>
#include <stdio.h>
#include <string.h>

static void work(long rounds)
{
    volatile double x = 1;
    for (long i = 0; i < rounds; i++)
        x = x * 1.000001 + 1e-9;
}

static void end(const char *how, long last)
{
    static volatile long *nowhere;
    if (strcmp(how, "waits") == 0)
        crecv(10 + last, NULL, 0);
    else if (strcmp(how, "errs") == 0)
        csend(1, NULL, 0, 100 + last, 0);
    else
        *nowhere = last;
}

int main(int argc, char **argv)
{
    long last = 0;
    if (mynode() == 0) {
        for (int i = 0; i < 5 * (numnodes() - 1); i++) {
            crecv(1, NULL, 0);
            last = 3 * last % 101 + infonode();
            printf("%ld ", infonode());
        }
        puts("");
        fflush(stdout);
        end(argc > 1 ? argv[1] : "", last);
    }
    for (int i = 0; i < 5; i++) {
        work(1000 * ((long)(dclock() * 1e7) % 97));
        csend(1, NULL, 0, 0, 0);
    }
    gsync();
    return 0;
}
