/* sleeps.c - node 1 sleeps; node 0 asks, and the handler of node 1 answers whether its program is awake. */
#include <stdio.h>
#include <unistd.h>
#include <nx.h>

static long question;
static volatile long awake = 1;

static void answer(long type, long count, long node, long pid)
{
    long now = awake;
    (void)type, (void)count, (void)pid;
    hrecv(1, &question, sizeof question, answer);
    csend(2, &now, sizeof now, node, 0);
}

static void ask(const char *during)
{
    long now;
    csend(1, &question, sizeof question, 1, 0);
    crecv(2, &now, sizeof now);
    printf("%s: %s\n", during, now ? "awake" : "asleep");
}

int main(void)
{
    if (mynode() == 1) {
        hrecv(1, &question, sizeof question, answer);
        awake = 0;
    }
    gsync();
    if (mynode() == 0) {
        ask("sleep");
        csend(3, &question, 0, 1, 0);
        ask("usleep");
    } else {
        double began = dclock();
        long left = sleep(1);
        printf("slept: %s\n", left == 0 && dclock() - began >= 1 ? "all of it" : "less");
        crecv(3, &question, 0);
        usleep(300000);
    }
    gsync();
    return 0;
}
