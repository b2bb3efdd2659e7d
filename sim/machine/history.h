/* history.h - all messages that have arrived, in the order of events: their counts and their digest, and
 * touchstone run --history. */
#ifndef MACHINE_HISTORY_H
#define MACHINE_HISTORY_H
#include "node/system.h"

/* A message has arrived. */
void history_add(struct node_system *sys, const struct message *m, vtime now);
#endif
