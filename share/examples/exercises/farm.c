/* farm.c - exercise 5: node 0 hands out 512 tasks; the others work, and ask for more.
 *
 *    nxcc -g -O2 -o farm farm.c
 *    touchstone run -q -m delta -n 16 farm 1000
 *
 * The argument is the size of a task. Node 0 serves one request after the other: it receives a request,
 * with the result of the last task, adds the result up, and sends the number of the next task. */
#include <stdio.h>
#include <stdlib.h>
#include <nx.h>

enum { REQUEST = 1, TASK = 2, TASKS = 512, NO_MORE = -1 };

volatile double kept;

/* A task: something that takes the longer, the larger its size. */
static double work(int size)
{
    double x = 0;
    int i;

    for (i = 1; i < size; i++)
        x = 0.5 * (x + 1.0 / i);
    return x;
}

/* Hands out all tasks; returns the sum of what has come for them. */
static double serve(void)
{
    double result, sum = 0;
    long next = 0, left = numnodes() - 1, none = NO_MORE;

    while (left > 0) {
        crecv(REQUEST, &result, sizeof result);
        sum += result;
        kept = work(20); /* what there is to do for a result */
        if (next < TASKS) {
            csend(TASK, &next, sizeof next, infonode(), 0);
            next++;
        } else {
            csend(TASK, &none, sizeof none, infonode(), 0);
            left--;
        }
    }
    return sum;
}

static void work_on(int size)
{
    double result = 0;
    long task;

    for (;;) {
        csend(REQUEST, &result, sizeof result, 0, 0);
        crecv(TASK, &task, sizeof task);
        if (task == NO_MORE)
            return;
        result = work(size);
    }
}

int main(int argc, char **argv)
{
    int size = argc > 1 ? atoi(argv[1]) : 1000;
    double begin, sum = 0;

    gsync();
    begin = dclock();
    if (mynode() == 0)
        sum = serve();
    else
        work_on(size);
    gsync();
    if (mynode() == 0)
        printf("sum %.6f\ntotal_s %.6f\n", sum, dclock() - begin);
    return 0;
}
