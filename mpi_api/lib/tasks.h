/* tasks.h - collectives under way: each has a stack, on which it runs until it has to wait for messages. It
 * goes on when the program is in a call that waits, tests or probes (MPI's rule of progress). */
#ifndef MPI_TASKS_H
#define MPI_TASKS_H
#include "coll.h"

struct task;

/* Begins, and runs as far as it comes. */
struct task *task_start(coll_run *run, const struct args *a);
bool task_is_done(const struct task *t);
/* The result of one that is done; frees it. */
int task_end(struct task *t);
/* Nobody asks for its result: it is freed once it is done. */
void task_detach(struct task *t);

/* Calls a function of the program: on the program's stack, not on a task's, which is small. */
void tasks_call(void (*function)(void *), void *with);

extern int tasks_under_way;
bool tasks_go_on_and_complete(const struct nxm_completion *c);
/* nxm_complete for calls of the program, and of tasks: tasks go on meanwhile. */
static inline bool tasks_complete(const struct nxm_completion *c)
{
    return SELDOM(tasks_under_way) ? tasks_go_on_and_complete(c) : nxm_complete(c);
}
/* Receives; while tasks are under way, they go on. */
static inline void tasks_receive(const struct nxm_envelope *e, void *at, size_t room, struct nxm_status *s)
{
    if (USUALLY(!tasks_under_way)) {
        nxm_recv(e, at, (long)room, s);
        return;
    }
    int id = (int)nxm_irecv(e, at, (long)room);
    tasks_go_on_and_complete(&(struct nxm_completion){e->call, NXM_WAIT, 1, &id, s});
}
/* Waits until the task is done. Runs all that can go on. */
void tasks_wait(int call, const struct task *t);
void tasks_go_on(int call);
/* Waits until something more comes that a task or one of these ids waits for, after tests have set the
 * statuses. */
void tasks_wait_for_any(int call, int count, const int ids[], const struct nxm_status status[]);
#endif
