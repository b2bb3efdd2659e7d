/* server.c - node 0 hands out numbers while it computes: requests interrupt it. The other nodes ask until there are no more. */
#include <cube.h>
#include <stdio.h>

#define ASK 10
#define ANSWER 11
#define JOBS 40

long who, next;
int served, told;

serve(type, count, node, pid) long type, count, node, pid;
{
    long job = next < JOBS ? next++ : -1;
    csend(ANSWER, &job, sizeof job, node, pid);
    if (job >= 0)
        served++;
    else
        told++;
    if (told < numnodes() - 1)
        hrecv(ASK, &who, sizeof who, serve);
}

main()
{
    long job, me = mynode(), done = 0, work, old;
    double x = 0;
    int i;

    if (me == 0)
        hrecv(ASK, &who, sizeof who, serve);
    gsync();
    if (me == 0) {
        while (told < numnodes() - 1) {
            for (i = 1; i < 1000; i++)
                x += 1.0 / i;
            old = masktrap(1); /* nobody else takes one meanwhile */
            if (next < JOBS) {
                next++;
                done++;
            }
            masktrap(old);
            flick();
        }
    } else
        for (;;) {
            csend(ASK, &me, sizeof me, 0, 0);
            crecv(ANSWER, &job, sizeof job);
            if (job < 0)
                break;
            for (i = 1; i < 20000; i++)
                x += 1.0 / i;
            done++;
        }
    work = done;
    gisum(&work, 1, &job);
    if (x < 0)
        printf("never\n");
    if (me == 0)
        printf("server: %ld jobs done, %s\n", work,
               done + served == JOBS && work == JOBS ? "each once" : "not each once");
}
