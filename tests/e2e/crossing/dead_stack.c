/* dead_stack.c - what a program finds where it has set nothing: below its stack pointer, in the registers
 * that a call leaves, in a jmp_buf, in the addresses of the C library's functions. It prints digests of
 * all that, and each word that is an address outside of the node's memory. */
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx.h"

enum { WORDS = 4000, LEFT_OUT = 8 };
static unsigned long words[WORDS];

static unsigned long digest(const unsigned long *w, int count)
{
    unsigned long h = 5381;
    for (int i = 0; i < count; i++)
        h = (h ^ w[i]) * 0x9e3779b97f4a7c15u, h ^= h >> 29;
    return h;
}

/* Addresses of this computer's: programs, libraries and stacks lie from 0x55... to 0x7f... */
static void look(const char *when)
{
    for (int i = 0; i < WORDS; i++)
        if (words[i] >> 40 >= 0x50 && words[i] >> 40 < 0x80)
            printf("%s: word %d is %lx\n", when, i, words[i]);
    printf("%ld %s %lx\n", mynode(), when, digest(words, WORDS));
}

/* Calls nothing while it copies, so that nothing is written there. */
__attribute__((noinline)) static void copy_dead(void)
{
    const volatile unsigned long *sp = __builtin_frame_address(0);
    for (int i = 0; i < WORDS; i++)
        words[i] = sp[-i - LEFT_OUT];
}

static int compare(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

static void handler(long type, long count, long node, long pid)
{
    char text[40];
    sprintf(text, "%ld %ld %ld %ld", type, count, node, pid);
}

static volatile double sum;
static void compute(int n)
{
    for (int i = 0; i < n; i++)
        sum += i;
}

int main(void)
{
    long me = mynode(), nodes = numnodes();
    char text[200], in[8] = "", got[8];
    int numbers[50];
    jmp_buf here;
    for (int round = 0; round < 5; round++) {
        hrecv(7, got, sizeof got, handler);
        csend(7, in, sizeof in, (me + 1) % nodes, 0);
        compute(3000 * (int)(me + 1));
        copy_dead();
        look("polls and a handler");
        csend(1, in, sizeof in, (me + 1) % nodes, 0);
        crecv(1, in, sizeof in);
        copy_dead();
        look("messages");
        sprintf(text, "%g %d %s %Lf", sum, round, "text", 1.5L);
        free(malloc(1000));
        copy_dead();
        look("the C library");
        for (int i = 0; i < 50; i++)
            numbers[i] = i * 37 % 50;
        qsort(numbers, 50, sizeof *numbers, compare);
        copy_dead();
        look("qsort");
        gsync();
        copy_dead();
        look("gsync");
    }
    unsigned long r[8] = {0};
    printf("x\n");
    __asm__ volatile(
        "movq %%rcx, (%0)\n movq %%rdx, 8(%0)\n movq %%rsi, 16(%0)\n movq %%r8, 24(%0)\n movq %%r9, 32(%0)\n"
        "movq %%r10, 40(%0)\n movq %%r11, 48(%0)\n movq %%xmm3, 56(%0)"
        :
        : "D"(r)
        : "memory");
    for (int i = 0; i < 8; i++)
        if (r[i])
            printf("register %d holds %lx\n", i, r[i]);
    memset(here, 0, sizeof here);
    if (setjmp(here) == 0) {
        memcpy(words, here, sizeof here);
        longjmp(here, 1);
    }
    /* Where it goes on; registers may hold what the compiled code counts, and the rest is the engine's. */
    printf("jmp_buf %lx, functions %p %p %p\n", digest(words + 6, 2), (void *)printf, (void *)crecv,
           (void *)qsort);
    return 0;
}
