/* protocol_number.c - see protocol_number.h. The numbers lie behind a message, before what a trace notes. */
#include "net/protocol_number.h"
#include "net/protocol_parts.h"

void protocol_number(struct protocol *p)
{
    for (unsigned i = 0; i < PROTOCOL_SIZES; i++)
        p->messages[i].bytes += sizeof(struct message_number);
}

struct message_number *protocol_number_of(const struct message *m)
{
    size_t size = (size_t)(protocol_pool_of(m) - m->protocol->messages);
    return (struct message_number *)((char *)m + sizeof *m + PROTOCOL_IN_MESSAGE[size]);
}

struct message *protocol_forwards(const struct message *m)
{
    return m->trip ? m->trip->forward : NULL;
}
