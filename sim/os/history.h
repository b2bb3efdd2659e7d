/* history.h - all messages that have arrived, in the order of events: their digest, and touchstone run
 * --history. */
#ifndef OS_HISTORY_H
#define OS_HISTORY_H
#include "node/system.h"

/* A message has arrived. */
void history_add(struct node_system *sys, const struct message *m, vtime now);
#endif
