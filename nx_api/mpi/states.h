/* states.h - what the nodes wait for, brought together on node 0 when all wait for ever (quiet.h). Each node
 * tells its state in one message; source lines are found on node 0, for addresses that all nodes share. */
#ifndef MPI_STATES_H
#define MPI_STATES_H
#include "backend_node.h"
#include "nx_api/waitfor/waitfor.h"

/* WIRE_ASK has come: sends this node's state to node 0. */
void states_tell(struct node *n);
/* WIRE_STATE has come. */
void states_heard(uint32_t source, const void *bytes, size_t count);
/* On node 0: asks all nodes and takes in their answers. To be freed by waitfor_free. */
struct waitfor *states_gather(struct node *n);
#endif
