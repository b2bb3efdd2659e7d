/* run_program.c - see run_program.h. */
#include "lp/run_program.h"
#include <errno.h>
#include "lp/clock.h"
#include "lp/dispatch.h"
#include "lp/prefetch_coming.h"
#include "lp/upcalls.h"

void lp_run(struct lp *lp)
{
    up_program_resumes(lp);
    errno = lp->saved_errno;
    fiber_resume(&lp->fiber);
    lp->crashed = up_program_returns(lp);
    if (lp->crashed)
        clock_doubt(lp);
    clock_sync(lp);
    lp->saved_errno = errno;
}

void lp_crash(struct lp *lp)
{
    if (lp->clock.runs)
        clock_crash(lp);
    lp_schedule(lp, clock_sync(lp));
}

void lp_run_here(struct lp *lp)
{
    slow_assert(lp->state == LP_COMPUTING);
    lp->schedule->unseen = 0;
    lp_run(lp);
    if (lp->crashed)
        lp_crash(lp);
    else if (lp->state == LP_OFFLOADED)
        workers_submit(lp->schedule->workers, &lp->offload.task);
}

inline void lp_run_on(struct lp *lp)
{
    if (lp->schedule->loads_ahead)
        prefetch_coming(lp->schedule);
    lp_run_here(lp);
}
