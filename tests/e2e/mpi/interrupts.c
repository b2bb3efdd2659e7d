/* A handler interrupts a computing program: node 0 makes no NX call until 200 messages have been handled, each sent when
 * the one before has been. It computes in a loop, in a function that calls itself, and in qsort's comparison. */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>

enum { MESSAGES = 200 };
static volatile long handled;
static char box[8];

static void handler(long type, long count, long node, long pid)
{
    (void)count, (void)pid;
    if (++handled < MESSAGES)
        hrecv(type, box, sizeof box, handler);
    csend(2, 0, 0, node, 0);
}

static long fibonacci(long n)
{
    return n < 2 ? n : fibonacci(n - 1) + fibonacci(n - 2);
}

static int compare(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

int main(void)
{
    static int numbers[100000];
    volatile double x = 0;
    long i;
    if (mynode() == 1) {
        for (i = 0; i < MESSAGES; i++) {
            csend(1, box, sizeof box, 0, 0);
            crecv(2, 0, 0);
        }
        return 0;
    }
    hrecv(1, box, sizeof box, handler);
    while (handled < MESSAGES / 4)
        x += 1;
    while (handled < MESSAGES / 2)
        if (fibonacci(15) != 610)
            printf("wrong\n");
    while (handled < MESSAGES * 3 / 4) {
        for (i = 0; i < 100000; i++)
            numbers[i] = (int)(i * 7919 % 100003);
        qsort(numbers, 100000, sizeof *numbers, compare);
    }
    while (handled < MESSAGES)
        ;
    printf("%ld handled\n", handled);
    return 0;
}
