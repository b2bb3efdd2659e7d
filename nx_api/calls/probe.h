/* probe.h - what a probe waits for. */
#ifndef CALLS_PROBE_H
#define CALLS_PROBE_H
#include "nx_api/calls/call.h"

/* For node_wait: is a message there that the struct incoming (receive.h) selects? */
bool nx_probe_finds(struct node *n, void *incoming);
#endif
