/* faults.c - faults HOW: the last node goes wrong in one way; the others wait for it. */
#define _GNU_SOURCE
#include <fenv.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx.h"

static jmp_buf out;
static volatile int zero;
static char *volatile low = (char *)8;

static void exits(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    puts("the handler exits");
    exit(4);
}

static void jumps(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    puts("the handler jumps");
    longjmp(out, 1);
}

static void crashes(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    *low = 1;
}

static void caught(int number)
{
    printf("caught %d\n", number);
}

__attribute__((noinline)) static int recurse(int n)
{
    volatile char page[1000];
    page[n % 1000] = (char)n;
    return n + recurse(n + 1) + page[0];
}

__attribute__((noinline)) static int divide(int a, int b)
{
    return a / b;
}

/* Unmasks invalid operation, division by zero and overflow, as programs of the time did for their tests. */
static void unmask(void)
{
    unsigned control;
    __asm__("stmxcsr %0" : "=m"(control));
    control &= ~0x680u;
    __asm__ volatile("ldmxcsr %0" ::"m"(control));
}

static volatile double nought, large = 1e308;

__attribute__((noinline)) static void copy(char *to)
{
    memcpy(to, low, 5 + (size_t)zero);
}

__attribute__((noinline)) static void overflow(volatile char *p, int n)
{
    p[n] = 1;
}

/* Waits for the handler, which node 0's message calls. */
static void wait_for(void (*handler)(long, long, long, long))
{
    static char buf[10];
    csend(6, buf, 1, 0, 0);
    hrecv(5, buf, 10, handler);
    while (dclock() < 1)
        ;
}

static void with_memory(const char *how)
{
    char *p = malloc(20);
    if (!strcmp(how, "heap"))
        overflow(p, 20), free(p);
    if (!strcmp(how, "heap_end"))
        overflow(p, 20), exit(0);
    if (!strcmp(how, "heap_before"))
        overflow(p, -1), free(p);
    if (!strcmp(how, "free_twice"))
        free(p), free(p);
    if (!strcmp(how, "free_other"))
        free((char *)&out + zero);
}

static void with_handlers(const char *how)
{
    if (!strcmp(how, "handler_exit"))
        wait_for(exits);
    if (!strcmp(how, "handler_crash"))
        wait_for(crashes);
    if (!strcmp(how, "handler_jump") && setjmp(out) == 0)
        wait_for(jumps);
    if (!strcmp(how, "handler_stays")) {
        if (setjmp(out) == 0)
            wait_for(jumps);
        for (;;)
            flick();
    }
}

static void with_signals(const char *how)
{
    if (!strcmp(how, "abort"))
        abort();
    if (!strcmp(how, "raise"))
        raise(SIGUSR1);
    if (!strcmp(how, "caught_fault")) {
        signal(SIGSEGV, caught);
        *low = 1;
    }
}

int main(int argc, char **argv)
{
    const char *how = argc > 1 ? argv[1] : "";
    char buf[1];
    printf("node %ld is there,", mynode());
    if (mynode() != numnodes() - 1) {
        if (!strncmp(how, "handler", 7) && mynode() == 0) {
            crecv(6, buf, 1);
            csend(5, buf, 1, numnodes() - 1, 0);
        }
        gsync();
        return 0;
    }
    if (!strcmp(how, "stack"))
        return recurse(1);
    if (!strcmp(how, "divide"))
        return divide(7, zero);
    if (!strncmp(how, "float_", 6))
        unmask();
    if (!strcmp(how, "enabled_divide")) {
        feenableexcept(FE_DIVBYZERO);
        large = large / nought;
    }
    if (!strcmp(how, "float_divide"))
        large = large / nought;
    if (!strcmp(how, "float_overflow"))
        large = large * large;
    if (!strcmp(how, "float_invalid"))
        large = nought / nought;
    if (!strcmp(how, "number"))
        printf("%s and more\n", low);
    if (!strcmp(how, "length"))
        gdsum((double *)&large, -1, (double *)&nought);
    if (!strcmp(how, "illegal"))
        __builtin_trap();
    if (!strcmp(how, "privileged"))
        __asm__ volatile("hlt");
    if (!strcmp(how, "no_function"))
        ((void (*volatile)(void))NULL)();
    if (!strcmp(how, "copy"))
        copy(buf);
    if (!strcmp(how, "constant"))
        overflow((char *)"a text in quotes" + zero, 0);
    if (!strcmp(how, "data_before"))
        for (volatile char *p = (char *)&out;; p--)
            *p = 1;
    if (!strcmp(how, "stack_end"))
        memset(buf + zero, 0, 1 << 16);
    if (!strcmp(how, "no_pointer")) {
        double number = 1.5;
        memcpy((void *)&low, &number, sizeof low);
        *low = 1;
    }
    if (!strcmp(how, "stdin"))
        printf("%d from stdin,", getchar());
    if (!strcmp(how, "deadlock"))
        crecv(77, buf, 1);
    if (!strcmp(how, "endless"))
        for (;;)
            ;
    with_memory(how);
    with_handlers(how);
    with_signals(how);
    gsync();
    puts("and went on");
    return 0;
}
