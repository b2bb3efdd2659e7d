/* plain.h - the patterns of cluster.c in plain MPI. Each runs `rounds` rounds on all nodes. */
#ifndef CLUSTER_PLAIN_H
#define CLUSTER_PLAIN_H

void plain_begin(void);
void plain_ping_pong(char *out, char *in, int bytes, int rounds);
void plain_halo(char *out, char *in, int bytes, int rounds);
void plain_sum(double *x, double *work, int count, int rounds);
void plain_barrier(int rounds);

#endif
