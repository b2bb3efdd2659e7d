/* block_holders.h - the messages that held channels for which others waited. */
#ifndef LAB_WHY_BLOCK_HOLDERS_H
#define LAB_WHY_BLOCK_HOLDERS_H
#include "lab/trace/trace_model.h"

/* For each block of the trace the message that held the channel when the block ended, or last before;
 * TRACE_NONE: not known. malloc'd. */
int32_t *block_holders_find(const struct trace *t);
#endif
