/* upcalls.c - the operating system's answers to lp/upcalls.h: those that both engines need. */
#include "lp/upcalls.h"
#include "node/system.h"
#include "os/charge.h"
#include "os/first_failure.h"
#include "os/due.h"
#include "os/isolate.h"
#include "os/share.h"

bool up_is_interruptible(const struct lp *lp)
{
    return due_may_interrupt(node_of(lp));
}

bool up_in_handler(const struct lp *lp)
{
    return node_of(lp)->in_handler;
}

vtime up_next_interrupt(const struct lp *lp)
{
    return due_next(node_of(lp));
}

bool up_may_resume(struct lp *lp, vtime now)
{
    struct node *n = node_of(lp);
    return !n->wait.ready || due_now(n, now) || n->wait.ready(n, n->wait.arg);
}

void up_wait_begins(struct lp *lp)
{
    charge_wait_begins(node_of(lp));
    share_end(node_of(lp));
}

void up_wait_ends(struct lp *lp, vtime t)
{
    charge_wait_ends(node_of(lp), t);
}

/* --- programs --- */

void up_program_resumes(struct lp *lp)
{
    isolate_run(node_of(lp));
}

bool up_program_returns(struct lp *lp)
{
    struct node *n = node_of(lp);
    if (!n->cold->crash)
        return false;
    n->sys->keep_crash(n);
    n->deferred.open = false;
    return true;
}

void up_report_crash(struct lp *lp)
{
    node_of(lp)->sys->crashed(node_of(lp));
}

void up_end_at_limit(struct schedule *s)
{
    node_system_end_at_limit(system_of(s));
}
