/* backend_node.h - the simulator's part of nx_api/contract/backend.h: its node, and its messages. */
#ifndef SIM_BACKEND_NODE_H
#define SIM_BACKEND_NODE_H
#include "node/engine.h"
#include "node/mailbox.h"
#include "node/system.h"
#include "nx_api/contract/backend.h"

/* The simulator binds names when it loads a program: sim/node/exports.def. */
#define NX_EXPORT(name)
#define NX_EXPORT_LONG32(name)
#endif
