/* endpoints.h - who lives at which address of the network: nodes, the host, and the machine's services. */
#ifndef MACHINE_ENDPOINTS_H
#define MACHINE_ENDPOINTS_H
#include "node/system.h"

/* The calls by which the protocol reaches the nodes of a machine and, if sys->cfs is set, the services of
 * its file system. */
struct protocol_nodes endpoints_calls(struct node_system *sys);
#endif
