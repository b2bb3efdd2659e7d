/* senders.c - the senders of messages: nx_api/contract/backend.h. */
#include "node/system.h"
#include "nx_api/contract/backend.h"

long nx_sender(const struct node *n, const struct message *m)
{
    return (long)node_number(n->sys, m->source);
}

const char *nx_sender_name(const struct node *n, const struct message *m)
{
    return node_at(n->sys, m->source)->cold->name;
}
