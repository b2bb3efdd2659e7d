/* msgwait.c - the calls that ask for message ids and give them back: msgwait, msgdone, msgcancel, msgignore,
 * msgmerge. */
#include "nx_api/calls/msgwait.h"

long nx_new_id(struct node *n, unsigned use)
{
    nx_settle(n);
    long id = mailbox_id_new(n, use, nx_message_ids(n));
    if (id < 0)
        return node_error(n, EQNOMID,
                          "out of message ids (%lu): msgwait, msgdone or msgcancel give them back",
                          (unsigned long)nx_message_ids(n));
    return id;
}

static long check_id(struct node *n, long id)
{
    if (mailbox_id_is_valid(n, id))
        return 0;
    return node_error(n, EQMID, "%ld is no message id in use", id);
}

bool nx_id_is_complete(struct node *n, void *id)
{
    return mailbox_id_is_complete(n, (intptr_t)id);
}

/* Puts the messages of a complete id into their buffers, and gives the id back, also after an error. */
static long take(struct node *n, long id)
{
    long result = 0;
    for (long i = id; i >= 0; i = mailbox_id_next(n, i)) {
        struct receive *r = mailbox_id_receive(n, i);
        if (r && mailbox_take(n, r) < 0)
            result = -1;
    }
    mailbox_id_release(n, id);
    return result;
}

long nxs_msgwait(word mid)
{
    struct node *n = node_self();
    long id = mid;
    nx_about(n, id);
    if (check_id(n, id) < 0)
        return -1;
    nx_spend_call(n);
    nx_awaits(n, mailbox_id_receive(n, id), mailbox_id_send(n, id));
    node_wait(n, nx_id_is_complete, (void *)(intptr_t)id);
    return take(n, id);
}

/* What the first part of an id that is not complete waits for; NULL: it is a send's. */
static const struct selector *missing(struct node *n, long id)
{
    const struct receive *r = NULL;
    for (long i = id; i >= 0; i = mailbox_id_next(n, i)) {
        r = mailbox_id_receive(n, i);
        if (!r || !mailbox_complete(n, r))
            break;
    }
    return r ? &r->select : NULL;
}

long nxs_msgdone(word id)
{
    struct node *n = node_self();
    nx_about(n, id);
    bool wrong = check_id(n, id) < 0, done = !wrong && mailbox_id_is_complete(n, id);
    node_answers(n, wrong || done);
    if (wrong)
        return -1;
    nx_spend_call(n);
    const struct selector *select = done ? NULL : missing(n, id);
    if (select)
        nx_found_nothing(n, select);
    if (done && take(n, id) < 0)
        return -1;
    return done;
}

long nxs_msgcancel(word id)
{
    struct node *n = node_self();
    nx_about(n, id);
    if (check_id(n, id) < 0)
        return -1;
    nx_spend_call(n);
    bool leaves = false;
    for (long i = id; i >= 0; i = mailbox_id_next(n, i))
        if (mailbox_id_receive(n, i))
            leaves |= mailbox_withdraw(n, mailbox_id_receive(n, i));
    if (leaves)
        mailbox_serve_posted(n);
    mailbox_id_release(n, id);
    return 0;
}

long nxs_msgignore(word id)
{
    struct node *n = node_self();
    nx_about(n, id);
    if (check_id(n, id) < 0)
        return -1;
    nx_spend_call(n);
    mailbox_id_ignore(n, id);
    return 0;
}

long nxs_msgmerge(word first, word second)
{
    struct node *n = node_self();
    nx_about(n, first);
    if (first == ANY && second == ANY)
        return node_error(n, EQMID, "neither is a message id");
    if ((first != ANY && check_id(n, first) < 0) || (second != ANY && check_id(n, second) < 0))
        return -1;
    if (first == second)
        return node_error(n, EQMID, "%d is given twice", first);
    nx_spend_call(n);
    if (first == ANY || second == ANY)
        return first == ANY ? second : first;
    mailbox_id_merge(n, first, second);
    return first;
}

static void take_ignored(struct node *n, long id)
{
    for (long i = id; i >= 0; i = mailbox_id_next(n, i)) {
        struct receive *r = mailbox_id_receive(n, i);
        if (r && mailbox_take(n, r) < 0)
            node_fail(n, "msgignore: %s", nx_last_error(n)->text);
    }
    mailbox_id_release(n, id);
}

static __attribute__((noinline)) void take_all_ignored(struct node *n)
{
    struct node_info before = n->info;
    for (long id = 0; (id = mailbox_id_take_ignored(n, id)) > 0;)
        take_ignored(n, id);
    n->info = before;
}

void nx_settle(struct node *n)
{
    if (mailbox_ids(n)->ignored)
        take_all_ignored(n);
}
