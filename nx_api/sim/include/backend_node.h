/* backend_node.h - the simulator's part of nx_api/contract/backend.h: its node, and its messages. */
#ifndef SIM_BACKEND_NODE_H
#define SIM_BACKEND_NODE_H
#include "node/self.h"
#include "node/system.h"
#include "nx_api/contract/backend.h"
#include "os/fail.h"
#include "os/front.h"
#include "os/gate.h"
#include "os/handlers.h"
#include "nx_api/contract/backend.h"
#include "os/match.h"

/* The simulator binds names when it loads a program: sim/guest/exports.def. */
#define NX_EXPORT(name)
#define NX_EXPORT_LONG32(name)
#endif
