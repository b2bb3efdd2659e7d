/* endpoints.h - who lives where on the network: messages go to nodes, or to services of the machine and back.
 */
#ifndef MACHINE_ENDPOINTS_H
#define MACHINE_ENDPOINTS_H
#include "node/system.h"

/* The protocol's upward calls for a machine with nodes and, if sys->cfs is set, a file system. */
struct protocol_nodes endpoints_calls(struct node_system *sys);
#endif
