/* awaited.c - see awaited.h. */
#include "nx_api/calls/awaited.h"
#include "nx_api/calls/msgwait.h"
#include "nx_api/calls/probe.h"
#include "nx_api/calls/process_calls.h"
#include "nx_api/calls/receive.h"
#include "nx_api/calls/send.h"

/* Of the parts of an id, the first that has no message, or has not been sent. */
static struct awaited of_id(struct node *n, long id)
{
    for (; id >= 0; id = mailbox_id_next(n, id)) {
        const struct receive *r = mailbox_id_receive(n, id);
        const struct send *s = mailbox_id_send(n, id);
        if (r && !r->m)
            return (struct awaited){.receive = r};
        if (s && !s->done)
            return (struct awaited){.send = s};
    }
    return (struct awaited){0};
}

struct awaited nx_awaited(struct node *n, bool (*ready)(struct node *n, void *arg), void *arg)
{
    if (ready == nx_receive_is_complete)
        return (struct awaited){.receive = arg};
    if (ready == nx_send_is_done)
        return (struct awaited){.send = arg};
    if (ready == nx_id_is_complete)
        return of_id(n, (intptr_t)arg);
    if (ready == nx_probe_finds)
        return (struct awaited){.probe = &((const struct incoming *)arg)->select};
    if (ready == nx_all_have_ended || ready == nx_one_has_ended)
        return (struct awaited){.end = true, .all = ready == nx_all_have_ended, .of = *(const word *)arg};
    return (struct awaited){0};
}
