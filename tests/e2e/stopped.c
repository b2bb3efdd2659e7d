/* stopped.c - stopped HOW: node 1 computes or waits without end; or crashes in a library call, or spoils what
 * the library needs; or is flooded with messages, or killed. Or node 0 reads. */
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx.h"

static char *volatile nowhere = (char *)0x1234;

static void show(const char *name)
{
    printf("name %s\n", name);
}

static void flood(int n)
{
    static char b[100];
    if (mynode())
        for (int i = 0; i < n; i++)
            csend(1, b, sizeof b, 0, 0);
    for (volatile long i = 0; i < 1000; i++)
        ;
    for (int i = 0; i < n * (numnodes() - 1) && mynode() == 0; i++)
        crecv(1, b, sizeof b);
}

static void enter_twice(long n)
{
    printf("loop\n");
    if (n > 5)
        printf("entered from two places\n");
here:
    goto here;
}

static void jump(void)
{
    static jmp_buf there;
    setjmp(there);
    longjmp(there, 1);
}

static void print_later(void)
{
    for (volatile long i = 0; i < 10000; i++)
        ;
    printf("later\n");
}

int main(int argc, char **argv)
{
    const char *how = argc > 1 ? argv[1] : "";
    printf("node %ld is there\n", mynode());
    if (!strcmp(how, "flood")) {
        flood(atoi(argv[2]));
    } else if (!strcmp(how, "reads")) {
        getchar();
    } else if (!strcmp(how, "killed")) {
        if (mynode())
            print_later();
        else
            killproc(1, 0);
    } else if (mynode() == 1) {
        if (!strcmp(how, "for"))
            for (;;)
                ;
        if (!strcmp(how, "goto"))
        here:
            goto here;
        if (!strcmp(how, "asm"))
            for (;;)
                __asm__ volatile("");
        if (!strcmp(how, "unseen")) /* by the compiler's plugin */
            __asm__ volatile("1: jmp 1b");
        if (!strcmp(how, "stream"))
            memset(stdout, 0xff, sizeof *stdout);
        if (!strcmp(how, "register"))
            __asm__ volatile("mov %0, %%fs" ::"r"(0));
        if (!strcmp(how, "given back")) /* as after that, where the kernel has set the register right since */
            __asm__ volatile("mov %%fs:0, %%rax; neg %%rax; mov %%fs:-8(%%rax), %%rax" ::: "rax");
        if (!strcmp(how, "entered"))
            enter_twice(numnodes());
        if (!strcmp(how, "longjmp"))
            jump();
        if (!strcmp(how, "calls"))
            while (dclock() >= 0)
                ;
        if (!strcmp(how, "printf"))
            show(nowhere);
        if (!strcmp(how, "strlen"))
            printf("%zu\n", strlen(nowhere));
    }
    gsync();
    return 0;
}
