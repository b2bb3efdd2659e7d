/* waits_for.h - the reasons for the waits of a machine that stands still: the wait-for graph
 * (nx_api/waitfor). */
#ifndef MACHINE_WAITS_FOR_H
#define MACHINE_WAITS_FOR_H
#include "node/system.h"
#include "nx_api/waitfor/waitfor.h"

/* The machine's graph, analysed. Every program has ended or waits, nothing is under way, and all calls are
 * committed. The caller frees it. */
struct waitfor *waits_for(const struct node_system *s);
#endif
