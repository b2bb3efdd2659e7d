/* fits.h - the check of whether the ranks' calls fit together. Of each collective the members are compared
 * with the one that came first; of each message the receive with the send. What is kept of a collective
 * goes when the last member has come, what is kept of a message when a receive has been given it. Messages
 * of one sender, receiver, tag and communicator are given to receives in the order sent (core.h), and so
 * are told apart. */
#ifndef MPI_FITS_H
#define MPI_FITS_H
#include "mpi_api/checks/mpi_findings.h"
#include "mpi_api/checks/signature.h"
#include "os/observer.h"

/* A receive that has no message yet. */
struct expected {
    const struct receive *receive;
    struct mpi_place place;
    struct signature signature;
};

/* Of one node; all 0 at first. */
struct fits_node {
    const struct nxm_told *call; /* that the program is in; NULL: none */
    const struct nxm_library *library;
    struct expected *list;
    size_t count, room;
};

void fits_node_free(struct fits_node *k);

struct fits;
struct fits *fits_new(struct mpi_findings *all);
void fits_free(struct fits *f);
/* The node has come to k->call. */
void fits_collective(struct fits_node *k, struct fits *f, struct node *n);
/* As observed. */
void fits_sends(struct fits_node *k, struct fits *f, struct node *n, const struct observed_send *what);
void fits_posts(struct fits_node *k, struct node *n, const struct receive *r);
void fits_withdraws(struct fits_node *k, const struct receive *r);
void fits_gives(struct fits_node *k, struct fits *f, struct node *n, const struct receive *r,
                const struct message *m);
/* The run is over: what was sent and never received. */
void fits_report(const struct fits *f);
#endif
