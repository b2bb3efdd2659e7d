/* flood.h - the end of a run whose nodes send what nobody receives. Short messages always find room, so that
 * a program which sends them for ever would fill this computer's memory before anybody is told. */
#ifndef OS_FLOOD_H
#define OS_FLOOD_H
#include "node/system.h"

/* What a message that waits counts beside its bytes: about what this computer needs for one. */
enum { FLOOD_EACH = 128 };

/* Bytes that messages may fill in a node, by what the user has said (0: nothing) and the node's memory: 4
 * times as many as it has, 4 GB at most. */
size_t flood_limit(size_t said, size_t memory);
/* m has come to n, where it waits: ends the run if too much does. */
void flood_check(struct node *n, const struct message *m);
#endif
