/* mpi_checks.c - see mpi_checks.h. */
#include "mpi_api/checks/mpi_checks.h"
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "mpi_api/checks/fits.h"
#include "mpi_api/checks/leftovers.h"
#include "mpi_api/checks/overlaps.h"
#include "os/observer.h"

struct mpi_checks {
    struct mpi_findings *findings;
    struct fits *fits;
};

/* Of one node. */
struct node_checks {
    struct observer observer; /* first */
    struct mpi_checks *all;
    struct leftovers leftovers;
    struct fits_node fits;
};

struct mpi_checks *mpi_checks_new(void)
{
    struct mpi_checks *all = xcalloc(1, sizeof *all);
    all->findings = mpi_findings_new();
    all->fits = fits_new(all->findings);
    return all;
}

void mpi_checks_free(struct mpi_checks *all)
{
    if (!all)
        return;
    fits_free(all->fits);
    mpi_findings_free(all->findings);
    free(all);
}

bool mpi_checks_print(struct mpi_checks *all, const char *before, FILE *f)
{
    if (!all)
        return false;
    fits_report(all->fits);
    return mpi_findings_print(all->findings, before, f);
}

static struct node_checks *checks_of(struct observer *o)
{
    return (struct node_checks *)o;
}

/* (Told on any thread: what belongs to all nodes is noted in their order.) */
static void hear_begins(struct observer *o, struct node *n, const struct nxm_told *c,
                        const struct nxm_library *l)
{
    struct node_checks *k = checks_of(o);
    k->leftovers.library = l;
    leftovers_begin(&k->leftovers, k->all->findings, n, c);
    if (k->fits.call && c < k->fits.call) /* by a function that the library has called */
        return;
    k->fits.call = c, k->fits.library = l;
    fits_collective(&k->fits, k->all->fits, n);
    overlaps_begin(k->all->findings, n, c, l);
}

static void hear_ends(struct observer *o, struct node *n, const struct nxm_told *c,
                      const struct nxm_library *l)
{
    struct node_checks *k = checks_of(o);
    (void)l;
    leftovers_end(&k->leftovers, k->all->findings, n, c);
    if (k->fits.call == c)
        k->fits.call = NULL;
}

static void hear_sends(struct observer *o, struct node *n, const struct observed_send *what)
{
    fits_sends(&checks_of(o)->fits, checks_of(o)->all->fits, n, what);
}

static void hear_posts(struct observer *o, struct node *n, struct receive *r)
{
    fits_posts(&checks_of(o)->fits, n, r);
}

static void hear_withdraws(struct observer *o, struct node *n, struct receive *r)
{
    (void)n;
    fits_withdraws(&checks_of(o)->fits, r);
}

static void hear_gives(struct observer *o, struct node *n, const struct receive *r, const struct message *m)
{
    fits_gives(&checks_of(o)->fits, checks_of(o)->all->fits, n, r, m);
}

/* (What else ends a program is reported anyway.) */
static void hear_ends_program(struct observer *o, struct node *n, vtime t)
{
    struct node_checks *k = checks_of(o);
    (void)t;
    if ((n->end.how == NODE_RETURNED || n->end.how == NODE_EXITED) && !n->end.exit_code)
        leftovers_ended(&k->leftovers, k->all->findings, n);
}

static const struct announcements checker = {
    .in_order = true,
    .ends = hear_ends_program,
    .library_begins = hear_begins,
    .library_ends = hear_ends,
    .sends = hear_sends,
    .posts = hear_posts,
    .withdraws = hear_withdraws,
    .gives = hear_gives,
};

void mpi_checks_begin(struct mpi_checks *all, struct node *n)
{
    if (!all)
        return;
    struct node_checks *k = xcalloc(1, sizeof *k);
    k->observer.hears = &checker;
    k->all = all;
    observer_add(n, &k->observer);
}

void mpi_checks_end(struct mpi_checks *all, struct node *n)
{
    struct node_checks *k = all ? checks_of(observer_of(n, &checker)) : NULL;
    if (!k)
        return;
    observer_remove(n, &k->observer);
    leftovers_free(&k->leftovers);
    fits_node_free(&k->fits);
    free(k);
}
