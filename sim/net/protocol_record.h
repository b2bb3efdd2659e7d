/* protocol_record.h - messages under way, told to the recorder of the run's trace (trace/recorder.h): the
 * times of each step, and the channels for which it waited. A message is told of when its trip is over. */
#ifndef NET_PROTOCOL_RECORD_H
#define NET_PROTOCOL_RECORD_H
#include "net/protocol.h"
#include "trace/recorder.h"

/* From now on messages are recorded. Call before any message is made. */
void protocol_record(struct protocol *p, struct recorder *r);
/* The run is over: tells of the messages that are still under way. */
void protocol_record_end(struct protocol *p);
/* The order, among its source's, of a message that has arrived in a run that is recorded. */
uint64_t protocol_recorded_order(const struct message *m);
/* The order of the message that an address makes next. */
uint64_t protocol_next_order(const struct protocol *p, uint32_t address);
#endif
