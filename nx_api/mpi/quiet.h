/* quiet.h - the search for quiescence: finds that all programs wait and nothing can end their waits, by
 * Safra's algorithm (safra.h). Its messages are WIRE_TOKEN; those it counts are the kinds before that
 * (mpi_wire.h).
 *
 * A node is at rest while its program has ended, or is in node_wait, where only a message can end the
 * wait: the conditions that calls wait for are made of what messages change, and handlers, too, run when
 * messages have come. A node is not at rest if its program computes, is in any call of the system (it
 * reads, sleeps in nanosleep, writes to a pipe), in sleep, usleep or iowait of libnx.a, which time or a
 * file ends, or has a timer running (alarm, setitimer), whose signal may do anything. So the algorithm's
 * conditions hold, and its judgement is no guess: a program that computes for a day, stops in a debugger or
 * waits for its input keeps the token, and nobody is told anything. A message counts as received when it
 * has come whole, and as sent before MPI gets it. Not seen are threads of the program's own, and signals of
 * other processes that a handler of the program's turns into a jump.
 *
 * The token costs a running program nothing: a node passes it on only when it has been at rest for
 * `patience` seconds without a pause. So the token lies still while any node computes or hears from
 * another. */
#ifndef MPI_QUIET_H
#define MPI_QUIET_H
#include "backend_node.h"

/* Reads NX_DEADLOCK on node 0, whose setting holds for all. */
void quiet_begin(struct node *n);
/* Messages that are counted have been sent; one has come. */
void quiet_sent(uint32_t count);
void quiet_received(void);
/* The token has come. */
void quiet_take(const void *bytes);
/* For a waiting loop of a node that has been at rest since then. True, on node 0 only: all nodes are at
 * rest for ever. */
bool quiet_look(struct node *n, double since);
/* For the end, when all programs have ended. Passes the token on at once. False: it may come here still. */
bool quiet_settle(struct node *n);
#endif
