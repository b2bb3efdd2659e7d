/* refused_file.h - the end of a run whose program used a file that the fence refuses. */
#ifndef MACHINE_REFUSED_FILE_H
#define MACHINE_REFUSED_FILE_H
#include "guest/libc/fence.h"
#include "node/node.h"

/* On the node's stack. Writes out what the program has printed; the message names file, call and lines, and
 * says which option allows the file. */
_Noreturn void refused_file(struct node *n, const struct fence_refusal *r);
#endif
