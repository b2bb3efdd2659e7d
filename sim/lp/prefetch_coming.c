/* prefetch_coming.c - see prefetch_coming.h. */
#include "lp/prefetch_coming.h"
#include "lp/lp.h"
#include "lp/upcalls.h"

/* The node whose program may run so many events after the next; NULL: unknown, or something else happens
 * then. */
static const struct lp *coming(const struct schedule *s, unsigned after)
{
    evq_fire *fire;
    const struct lp *lp = evq_coming(s->q, after, &fire);
    return fire == s->resumes[0] || fire == s->resumes[1] ? lp : NULL;
}

/* Prefetches a program's entry in the page tables: four at a time take hardly longer than one. That of its
 * counter has its entry in the same line of the page tables. */
static void load_page(const struct lp *lp)
{
    if (lp && lp->state != LP_OFFLOADED && fiber_innermost(&lp->fiber))
        __builtin_prefetch(fiber_innermost(&lp->fiber), 1);
}

void prefetch_coming(struct schedule *s)
{
    enum { FIRST = 10, TOGETHER = 4, PAGES = 4, SECOND = 4, THIRD = 2 };
    const struct lp *lp = coming(s, FIRST);
    s->switches++;
    if (lp)
        up_prefetch_node(lp);
    for (unsigned i = 0; s->switches % TOGETHER == 0 && i < TOGETHER; i++)
        load_page(coming(s, PAGES + i));
    lp = coming(s, SECOND);
    if (lp && lp->state != LP_OFFLOADED)
        up_prefetch_receives(lp);
    lp = coming(s, THIRD);
    if (lp && lp->state != LP_ENDED && lp->state != LP_OFFLOADED && fiber_innermost(&lp->fiber)) {
        up_prefetch_messages(lp);
        up_prefetch_program(lp);
    }
}
