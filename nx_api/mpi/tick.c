/* tick.c - see tick.h; and nxc_enter, which a poll calls. */
#include "nx_api/mpi/tick.h"
#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <sys/prctl.h>
#include <time.h>
#include "nx_api/mpi/bells.h"
#include "nx_api/nxcc/runtime/enter.h"

enum { OFTEN_NS = 200000, VERY_OFTEN_NS = 30000, SELDOM_NS = 2000000 };

static atomic_bool often, resting;
static long often_ns;

static void *tick(void *unused)
{
    prctl(PR_SET_TIMERSLACK, 1000); /* the kernel's default adds 0.05 ms to each pause */
    for (;;) {
        bool soon = atomic_load_explicit(&often, memory_order_relaxed) &&
                    !atomic_load_explicit(&resting, memory_order_relaxed);
        nanosleep(&(struct timespec){.tv_nsec = soon ? often_ns : SELDOM_NS}, NULL);
        nxc_due = 1;
    }
    return unused;
}

bool tick_start(bool rung)
{
    often_ns = rung ? OFTEN_NS : VERY_OFTEN_NS;
    sigset_t all, before;
    pthread_t thread;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before); /* the program's own thread gets all signals */
    int error = pthread_create(&thread, NULL, tick, NULL);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    errno = error;
    return !error;
}

void tick_often(bool yes)
{
    atomic_store_explicit(&often, yes, memory_order_relaxed);
    if (yes)
        bell_want();
}

void tick_rest(bool yes)
{
    atomic_store_explicit(&resting, yes, memory_order_relaxed);
}

/* nxc_enter is called from the inline assembly of a poll, where no register has been saved and the stack may
 * have any alignment. xsave saves vector registers of any width. Its area is aligned to 64 bytes, has a
 * header of 64 bytes behind the first 512, which must be 0, and here room for the state of AVX-512. A
 * processor without xsave has only registers that fxsave saves. */
__attribute__((
    visibility("hidden"))) unsigned nxc_saved; /* the parts of the state to be saved; 0: no xsave */

__asm__(".text\n" NXC_BEGIN_SAVING("nxc_enter") "    subq $2816, %rsp\n"
                                                "    andq $-64, %rsp\n"
                                                "    cld\n"
                                                "    movl nxc_saved(%rip), %eax\n"
                                                "    testl %eax, %eax\n"
                                                "    jz 1f\n"
                                                "    xorl %edx, %edx\n"
                                                "    movq %rdx, 512(%rsp)\n"
                                                "    movq %rdx, 520(%rsp)\n"
                                                "    movq %rdx, 528(%rsp)\n"
                                                "    movq %rdx, 536(%rsp)\n"
                                                "    movq %rdx, 544(%rsp)\n"
                                                "    movq %rdx, 552(%rsp)\n"
                                                "    movq %rdx, 560(%rsp)\n"
                                                "    movq %rdx, 568(%rsp)\n"
                                                "    xsave64 (%rsp)\n"
                                                "    call nxc_preempt\n"
                                                "    movl nxc_saved(%rip), %eax\n"
                                                "    xorl %edx, %edx\n"
                                                "    xrstor64 (%rsp)\n"
                                                "    jmp 2f\n"
                                                "1:  fxsave64 (%rsp)\n"
                                                "    call nxc_preempt\n"
                                                "    fxrstor64 (%rsp)\n"
                                                "2:\n" NXC_END_ROUTINE("nxc_enter") ".globl nxc_enter_end\n"
                                                                                    ".hidden nxc_enter_end\n"
                                                                                    "nxc_enter_end:\n");
