/* endpoint.h - calls by which the protocol asks those who live at the addresses of a network: the only
 * calls up from sim/net, which sim/machine implements (endpoints.c). `ends` is as given to protocol_new. */
#ifndef NET_ENDPOINT_H
#define NET_ENDPOINT_H
#include "net/protocol.h"

/* At which end of a message a processor works. */
enum protocol_task { PROTOCOL_SEND, PROTOCOL_RECEIVE };

/* The operating system at an address works for t, from `at` on or from when it is free; returns when it has
 * finished. */
vtime endpoint_work(void *ends, uint32_t address, enum protocol_task task, vtime at, vtime t);
/* The processor at an address moves bytes by programmed I/O for t in all, from `at` on. The work above
 * interrupts programmed I/O and is not held up by it: both directions of an exchange go on at once. */
void endpoint_pio(void *ends, uint32_t address, enum protocol_task task, vtime at, vtime t);
/* An envelope has arrived: match it with a receive, or find a buffer. Returns false if there is no room yet;
 * call protocol_clear_to_send() later. Returns false for a forced message without a posted receive, too: the
 * protocol drops and frees the message. */
bool endpoint_envelope(void *ends, struct message *m, vtime now);
/* The sender's buffer of a message that is `followed` may be used again. */
void endpoint_sent(void *ends, struct message *m, vtime now);
void endpoint_arrived(void *ends, struct message *m, vtime now); /* m->complete is set */
#endif
