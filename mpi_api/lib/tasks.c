/* tasks.c - see tasks.h. */
#include "tasks.h"
#include <stdlib.h>
#include <string.h>

enum { STACK_BYTES = 32768 };

struct task {
    struct task *next;
    coll_run *run;
    struct args args;
    bool done, detached;
    int result;
    void *own_stack, *main_stack; /* where each has left off */
    const struct nxm_completion *awaits;
    void (*calls)(void *); /* what is to be called on the program's stack */
    void *with;
    char stack[STACK_BYTES] __attribute__((aligned(16)));
};

READ_OFTEN int tasks_under_way;
static struct task *tasks, *current; /* in the order of their beginning */

/* Goes on where `to` has left off, and leaves off where *from says then. */
void mpi_switch_stacks(void **from, void *to);
__asm__(".text\n"
        ".type mpi_switch_stacks, @function\n"
        "mpi_switch_stacks:\n"
        "    push %rbp\n"
        "    push %rbx\n"
        "    push %r12\n"
        "    push %r13\n"
        "    push %r14\n"
        "    push %r15\n"
        "    mov %rsp, (%rdi)\n"
        "    mov %rsi, %rsp\n"
        "    pop %r15\n"
        "    pop %r14\n"
        "    pop %r13\n"
        "    pop %r12\n"
        "    pop %rbx\n"
        "    pop %rbp\n"
        "    ret\n"
        ".size mpi_switch_stacks, . - mpi_switch_stacks\n");

static void leave(struct task *t)
{
    current = NULL;
    mpi_switch_stacks(&t->own_stack, t->main_stack);
}

static void go_on(struct task *t)
{
    for (;;) {
        t->calls = NULL;
        current = t;
        mpi_switch_stacks(&t->main_stack, t->own_stack);
        if (!t->calls)
            return;
        t->calls(t->with);
    }
}

void tasks_call(void (*function)(void *), void *with)
{
    struct task *t = current;
    if (!t) {
        function(with);
    } else {
        t->calls = function, t->with = with;
        leave(t);
    }
}

static void body(void)
{
    struct task *t = current;
    t->result = t->run(&t->args);
    t->done = true;
    leave(t);
}

static void unlink_task(struct task *t)
{
    struct task **link = &tasks;
    while (*link != t)
        link = &(*link)->next;
    *link = t->next;
    tasks_under_way--;
}

/* Runs t until it waits, or is done. */
static void run(struct task *t)
{
    go_on(t);
    if (t->done)
        unlink_task(t);
    if (t->done && t->detached)
        task_end(t);
}

struct task *task_start(coll_run *function, const struct args *a)
{
    struct task *t = get_memory(sizeof *t), **last = &tasks;
    t->next = NULL, t->run = function, t->args = *a, t->done = t->detached = false;
    args_keep(a);
    /* Six registers, of no meaning, and where the first switch returns to; the stack as a call leaves it. */
    void **top = (void **)(t->stack + STACK_BYTES) - 1;
    *--top = (void *)body;
    for (int i = 0; i < 6; i++)
        *--top = NULL;
    t->own_stack = top;
    while (*last)
        last = &(*last)->next;
    *last = t;
    tasks_under_way++;
    run(t);
    return t;
}

void task_detach(struct task *t)
{
    t->detached = true;
    if (t->done)
        task_end(t);
}

bool task_is_done(const struct task *t)
{
    return t->done;
}

int task_end(struct task *t)
{
    int result = t->result;
    args_leave(&t->args);
    free(t);
    return result;
}

/* --- progress --- */

void tasks_go_on(int call)
{
    for (struct task *t = tasks, *next; t; t = next) {
        next = t->next;
        struct nxm_completion c = *t->awaits;
        c.how = NXM_ALL, c.call = call;
        if (nxm_complete(&c))
            run(t);
    }
}

/* Adds those ids that have not arrived. */
static int add_ids(int *list, int n, int count, const int ids[], const struct nxm_status status[])
{
    for (int i = 0; i < count; i++)
        if (ids[i] && !status[i].arrived)
            list[n++] = ids[i];
    return n;
}

void tasks_wait_for_any(int call, int count, const int ids[], const struct nxm_status own[])
{
    int all = count, n;
    for (const struct task *t = tasks; t; t = t->next)
        all += t->awaits->count;
    int *list = get_memory((size_t)all * sizeof *list);
    struct nxm_status *status = get_memory((size_t)all * sizeof *status);
    n = add_ids(list, 0, count, ids, own);
    for (const struct task *t = tasks; t; t = t->next)
        n = add_ids(list, n, t->awaits->count, t->awaits->ids, t->awaits->status);
    nxm_complete(&(struct nxm_completion){call, NXM_WAIT | NXM_ANY | NXM_LEAVE, n, list, status});
    free(list);
    free(status);
}

/* A task waits: the program goes on, and the task when it all is there. */
static bool complete_in_task(const struct nxm_completion *c)
{
    struct task *t = current;
    struct nxm_completion look = *c;
    look.how &= ~NXM_WAIT;
    if (nxm_complete(&look))
        return true;
    t->awaits = c;
    leave(t);
    return true;
}

bool tasks_go_on_and_complete(const struct nxm_completion *c)
{
    struct nxm_completion look = *c;
    if (current)
        return complete_in_task(c);
    look.how &= ~NXM_WAIT;
    for (;;) {
        tasks_go_on(c->call);
        if (nxm_complete(&look))
            return true;
        if (!(c->how & NXM_WAIT))
            return false;
        if (tasks_under_way)
            tasks_wait_for_any(c->call, c->count, c->ids, c->status);
        else
            return nxm_complete(c);
    }
}

void tasks_wait(int call, const struct task *t)
{
    while (tasks_go_on(call), !t->done)
        tasks_wait_for_any(call, 0, NULL, NULL);
}
