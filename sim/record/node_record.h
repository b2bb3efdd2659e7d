/* node_record.h - what a node's program and system do, told to the recorder of the run's trace
 * (trace/recorder.h): an observer (os/observer.h). A call is told of when it ends, since it refers to what it
 * sent, took and waited for; until then it lies on a small stack: a call, a handler that interrupts it, a
 * call of the handler.
 *
 * A deferred call (deferred.h) lies in a ring of its own until it is committed: only then its times are
 * known. If its program is still in the call then, the call goes on as one that is not deferred. What the
 * node does while a deferred call is open is about that call.
 *
 * When the program ends, or the run, what is open ends; unfinished, unless the program has ended itself. */
#ifndef RECORD_NODE_RECORD_H
#define RECORD_NODE_RECORD_H
#include "node/system.h"

/* Begins the record of a node that runs a program by its number; none if the trace leaves out the node. */
void record_begin(struct node *n, uint32_t program);
#endif
