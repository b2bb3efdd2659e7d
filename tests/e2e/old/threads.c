/* threads.c - a thread package: each thread has a stack from malloc and runs until it yields. Those that
 * wait for a message let others run. */
#include <cube.h>
#include <stdio.h>

#define MAX 8
#define STACK 32768

struct thread {
    char *sp;
    int (*entry)(), argument, over;
} threads[MAX + 1];
int count, current;

char *malloc();
char *thread_stack();

t_begin()
{
    (*threads[current].entry)(threads[current].argument);
    threads[current].over = 1;
    t_yield();
}

t_create(entry, argument) int (*entry)();
{
    struct thread *t = &threads[++count];
    t->entry = entry;
    t->argument = argument;
    t->sp = thread_stack(malloc(STACK) + STACK, t_begin);
}

/* Number 0 is main's. */
t_yield()
{
    int old = current;
    do
        current = (current + 1) % (count + 1);
    while (threads[current].over);
    thread_switch(&threads[old].sp, threads[current].sp);
}

t_receive(type, buf, n) char *buf;
{
    while (!iprobe(type))
        t_yield();
    crecv(type, buf, n);
}

int sum;

worker(i)
{
    int other, me = mynode(), mine = 100 * me + i;
    csend(i, &mine, sizeof mine, (me + 1) % numnodes(), 0);
    t_receive(i, &other, sizeof other);
    sum += other;
}

main()
{
    int i, over;
    long total, work;
    for (i = MAX; i > 0; i--)
        t_create(worker, i);
    do {
        t_yield();
        for (over = 0, i = 1; i <= MAX; i++)
            over += threads[i].over;
    } while (over < MAX);
    total = sum;
    gisum(&total, 1, &work);
    if (mynode() == 0)
        printf("threads: %ld\n", total);
}
