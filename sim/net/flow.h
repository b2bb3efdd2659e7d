/* flow.h - of many messages on their way to one place: which of one sender's was sent first. For proto_message.c, which looks
 * through its list where there are few. */
#ifndef NET_FLOW_H
#define NET_FLOW_H
#include <stdint.h>

struct trip;
struct flows;

struct flows *flows_new(void);
void flows_free(struct flows *f);
/* t, whose source and order stay what they are, is one of them; and no more. */
void flows_add(struct flows *f, struct trip *t);
void flows_remove(struct flows *f, struct trip *t);
/* Of a sender's that are there, the first. NULL: there is none. */
struct trip *flows_first(const struct flows *f, uint32_t source);
#endif
