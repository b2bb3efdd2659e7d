/* flame.c - for flame.sh: recursion, functions called back, a handler that computes, longjmp out of calls,
 * and exit inside of a function. Node 0 waits for what node 1 computes. */
#include <nx.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>

static jmp_buf back;
static volatile long handled;

__attribute__((noinline)) static long work(long n)
{
    volatile long sum = 0;
    for (long i = 0; i < n; i++)
        sum += i % 7;
    return sum;
}

__attribute__((noinline)) static long deep(long n)
{
    volatile long here = n;
    return n > 0 ? deep(n - 1) + here : work(50);
}

__attribute__((noinline)) static int compare(const void *a, const void *b)
{
    return (int)(work(3) - 3) + (*(const int *)a > *(const int *)b) - (*(const int *)a < *(const int *)b);
}

__attribute__((noinline)) static void jump(int n)
{
    work(20);
    if (n == 0)
        longjmp(back, 1);
    jump(n - 1);
    work(1);
}

__attribute__((noinline)) static void catch_jump(void)
{
    if (!setjmp(back))
        jump(3);
    work(11);
}

static void handler(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    work(30);
    handled++;
}

__attribute__((noinline)) static void leave(void)
{
    work(13);
    fflush(stdout);
    exit(0);
}

int main(void)
{
    static int numbers[20];
    long token = 1;
    if (mynode() == 0) {
        static long got;
        hrecv(7, &got, sizeof got, handler);
        work(20000);
        crecv(8, &token, sizeof token);
        printf("%ld handled\n", handled);
    } else if (mynode() == 1) {
        work(100);
        csend(7, &token, sizeof token, 0, 0);
        work(100000);
        csend(8, &token, sizeof token, 0, 0);
    }
    deep(5);
    catch_jump();
    catch_jump();
    for (int i = 0; i < 20; i++)
        numbers[i] = i * 7 % 20;
    qsort(numbers, 20, sizeof *numbers, compare);
    gsync();
    leave();
    return 1;
}
