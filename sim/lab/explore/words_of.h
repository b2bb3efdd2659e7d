/* words_of.h - nodes, times and counts of recordings in words. Each function fills buf and returns it. */
#ifndef LAB_EXPLORE_WORDS_OF_H
#define LAB_EXPLORE_WORDS_OF_H
#include <stdint.h>
#include "kernel/vtime.h"

enum { REC_NAME = 24, REC_TIME = 32, REC_ORDINAL = 24 };

/* "node 3"; "the host", which has the number `nodes`. */
const char *rec_node_name(uint32_t node, uint32_t nodes, char buf[REC_NAME]);
/* "45.2 us" of picoseconds. */
const char *rec_duration(int64_t ps, char buf[REC_TIME]);
/* "123.456 us" of virtual time; "an unknown time" of VT_NEVER. */
const char *rec_time(vtime t, char buf[REC_TIME]);
/* "1st" of 0, "18th" of 17. */
const char *rec_ordinal(uint64_t from_0, char buf[REC_ORDINAL]);
#endif
