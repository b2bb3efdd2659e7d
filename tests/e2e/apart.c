/* apart.c - apart WHAT: a node accesses memory that is not its own; WHAT says how. */
#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx.h"

static double shared[4000];
static volatile int zero;

/* Only the middle of a large array is used: what lies between it and the stack's end is never touched. */
__attribute__((noinline)) static double large_frame(int n)
{
    volatile double a[130000];
    for (int i = 0; i < n; i++)
        a[i] = i;
    return a[n - 1];
}

__attribute__((noinline)) static long any_frame(long n)
{
    volatile char a[n];
    a[100] = 7;
    return a[100];
}

static void overrun(volatile char *p)
{
    for (long i = 0;; i++)
        p[i] = 7;
}

static void write_to_other(void)
{
    double *p = shared;
    if (mynode() == 0)
        csend(1, &p, sizeof p, 1, 0);
    if (mynode() != 1)
        return;
    crecv(1, &p, sizeof p);
    printf("read %g\n", p[0]);
    p[0] = 1;
}

static void damage(const char *what)
{
    volatile char *a = malloc(10), *b = malloc(100);
    if (!strcmp(what, "behind"))
        a[10 + zero] = 1;
    else if (!strcmp(what, "head"))
        a[20 + zero] = 1;
    else if (!strcmp(what, "before"))
        b[-3 + zero] = 1;
    else if (!strcmp(what, "free"))
        a[11 + zero] = 1, free((void *)a);
    else if (!strcmp(what, "realloc"))
        b[100 + zero] = 1, b = realloc((void *)b, 200);
    printf("%d\n", b == a);
}

/* Calls from a stack that the program has made itself. */
static void *main_sp, *other_sp;
void change_stack(void **save, void *load);
__asm__(".text\nchange_stack:\n push %rbp\n push %rbx\n push %r12\n push %r13\n push %r14\n push %r15\n"
        " mov %rsp,(%rdi)\n mov %rsi,%rsp\n pop %r15\n pop %r14\n pop %r13\n pop %r12\n pop %rbx\n pop %rbp\n"
        " ret\n");
static char data_room[65536] __attribute__((aligned(16)));

static void on_other_stack(void)
{
    long other = (mynode() + 1) % numnodes(), from = -1;
    csend(5, &other, sizeof other, other, 0);
    crecv(5, &from, sizeof from);
    gsync();
    char *p = malloc(100);
    printf("node %ld of %ld: %ld, %d, %.1f\n", mynode(), numnodes(), from, p != NULL, dclock() * 0);
    change_stack(&other_sp, main_sp);
}

static void other_stack(char *room, size_t bytes)
{
    void **sp = (void **)(room + bytes - 16);
    *--sp = 0;
    *--sp = (void *)on_other_stack;
    sp -= 6;
    change_stack(&main_sp, sp);
}

int main(int argc, char **argv)
{
    const char *what = argv[1];
    for (int i = 0; i < 4000; i++)
        shared[i] = mynode();
    gsync();
    if (!strcmp(what, "other"))
        write_to_other();
    else if (!strcmp(what, "stacks"))
        other_stack(malloc(65536), 65536), other_stack(data_room, sizeof data_room);
    else if (!strcmp(what, "addresses"))
        printf("%p %p %p %p\n", malloc(1000), (void *)shared, (void *)&argc, (void *)&errno);
    else if (!strcmp(what, "near"))
        printf("%d\n", labs((char *)malloc(1000000) - (char *)shared) < 1L << 31 &&
                           labs((char *)&argc - (char *)shared) < 1L << 31);
    else if (!strcmp(what, "low"))
        printf("%d\n", (uintptr_t)malloc(1000) >> 32 == 0 && (uintptr_t)shared >> 32 == 0 &&
                           (uintptr_t)&argc >> 32 == 0);
    else if (mynode() != numnodes() - 1)
        ;
    else if (!strcmp(what, "frame"))
        printf("%g\n", large_frame(3000));
    else if (!strcmp(what, "array"))
        printf("%ld\n", any_frame(atol(argv[2])));
    else if (!strcmp(what, "heap"))
        overrun(malloc(1000));
    else if (!strcmp(what, "data"))
        overrun((char *)shared);
    else
        damage(what);
    gsync();
    for (int i = 0; i < 4000; i++)
        if (shared[i] != mynode())
            exit(9);
    return 0;
}
