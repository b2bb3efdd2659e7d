/* completion.h - the end of receives and sends that have ids. */
#ifndef MPI_COMPLETION_H
#define MPI_COMPLETION_H
#include "mpi_api/core/core.h"
#include "nx_api/calls/awaited.h"

/* A call by its number, as reports name it. */
const char *completion_call_name(int call);
/* What a receive of the message is told. */
struct nxm_status completion_status(const struct node *n, const struct message *m);
/* Puts the message of a receive that is complete into its buffer. */
void completion_take(struct node *n, struct receive *r, struct nxm_status *status);
/* nxm_complete, in a call. */
bool completion_run(struct node *n, const struct nxm_completion *c);
/* One that is looked at again and again; `missing`: where the last look has found one that is not done. All
 * that a look needs lies here, most often, not in the program's memory, which then is in no cache near. */
enum { COMPLETION_FEW = 8 };
struct completion_look {
    int how, count, missing;
    const int *ids; /* few, or the program's */
    int few[COMPLETION_FEW];
};
/* For node_wait, given a struct completion_look; and what it still waits for, for reports. */
bool completion_is_ready(struct node *n, void *look);
struct awaited completion_awaits(struct node *n, const struct completion_look *l);
#endif
