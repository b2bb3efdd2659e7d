/* calls.c - the NX calls of nx.h, served by the simulator. Each runs on the calling node's stack: it enters
 * (time and order), spends the operating system's time, does its work on the mailbox or the protocol, and
 * leaves.
 *
 * Arguments are C longs, but only their low 32 bits count, as signed: programs without prototypes pass int.
 */
#include <stdint.h>
#include <stdio.h>
#include "node/cpu.h"
#include "node/mailbox.h"
#include "node/system.h"

#define LOW(x) ((long)(int32_t)(x))

enum { ALL_NODES = -1 };

static struct node *enter(const char *call)
{
    struct node *n = node_self();
    node_enter(n, call);
    return n;
}

/* A call that has a type, typesel or id worth showing in reports. */
static struct node *enter_with(const char *call, long what)
{
    struct node *n = enter(call);
    n->call_type = n->awaited = what;
    n->call_has_type = n->awaits = true;
    return n;
}

/* --- sending --- */

static void check_send(struct node *n, long type, const void *buf, long len, long node)
{
    long count = n->sys->count;
    if (node == count)
        node_fail(n, "%s: node %ld is the host, and no host program runs", n->call, node);
    if (node != ALL_NODES && (node < 0 || node > count))
        node_fail(n, "%s: there is no node %ld (nodes are 0 to %ld; -1 is all others)", n->call, node,
                  count - 1);
    if (type < 0 || type > 1999999999)
        node_fail(n, "%s: type %ld is out of range (0 to 999999999; force types 1073741824 to 1999999999)",
                  n->call, type);
    if (len < 0)
        node_fail(n, "%s: length %ld is negative", n->call, len);
    if (len > 0 && !buf)
        node_fail(n, "%s: the buffer is a null pointer", n->call);
}

/* To one node or all others. s, if not NULL, learns when buf may be used again: when the last message that this node
 * itself sends is gone. */
static void send_all(struct node *n, long type, const void *buf, long len, long node, struct send *s)
{
    struct proto *p = n->sys->proto;
    bool all = node == ALL_NODES;
    struct message *m = all ? proto_to_all(p, n->id, type, 0, buf, (size_t)len)
                            : proto_message(p, n->id, (uint32_t)node, type, 0, buf, (size_t)len);
    uint64_t receivers = all ? n->sys->count - 1 : 1;
    n->stats.sent += receivers;
    n->stats.sent_bytes += receivers * (uint64_t)len;
    if (!m && s)
        s->done = true;
    for (struct message *next; m; m = next) {
        next = m->also;
        if (!next && s)
            mailbox_follow(m, s);
        node_spend_on(n, NODE_SENDING, proto_send_time(p, type, (size_t)len));
        proto_send(p, m, node_now(n));
    }
}

static bool send_is_done(struct node *n, void *arg)
{
    (void)n;
    return ((struct send *)arg)->done;
}

void node_csend(long type, const void *buf, long len, long node, long pid);
void node_csend(long type, const void *buf, long len, long node, long pid)
{
    struct node *n = enter_with("csend", LOW(type));
    struct send s = {0};
    (void)pid;
    check_send(n, LOW(type), buf, LOW(len), LOW(node));
    send_all(n, LOW(type), buf, LOW(len), LOW(node), &s);
    node_order(n);
    node_wait(n, send_is_done, &s);
    node_leave(n);
}

static long new_id(struct node *n, bool sends)
{
    long id = mailbox_id_new(n, sends);
    if (id < 0)
        node_fail(n, "%s: out of message ids (%lu): msgwait, msgdone or msgcancel give them back", n->call,
                  (unsigned long)n->sys->cfg->message_ids);
    return id;
}

long node_isend(long type, const void *buf, long len, long node, long pid);
long node_isend(long type, const void *buf, long len, long node, long pid)
{
    struct node *n = enter_with("isend", LOW(type));
    (void)pid;
    check_send(n, LOW(type), buf, LOW(len), LOW(node));
    long id = new_id(n, true);
    send_all(n, LOW(type), buf, LOW(len), LOW(node), mailbox_id_send(n, id));
    node_leave(n);
    return id;
}

void node_hsend(long type, const void *buf, long len, long node, long pid, node_handler *handler);
void node_hsend(long type, const void *buf, long len, long node, long pid, node_handler *handler)
{
    struct node *n = enter_with("hsend", LOW(type));
    check_send(n, LOW(type), buf, LOW(len), LOW(node));
    struct send *s = mailbox_send_handler(n, handler);
    s->info = (struct node_info){LOW(type), LOW(len), LOW(node), LOW(pid)};
    send_all(n, LOW(type), buf, LOW(len), LOW(node), s);
    node_leave(n);
}

/* --- receiving --- */

static struct receive a_receive(struct node *n, long typesel, void *buf, long len)
{
    if (len < 0)
        node_fail(n, "%s: length %ld is negative", n->call, len);
    if (len > 0 && !buf)
        node_fail(n, "%s: the buffer is a null pointer", n->call);
    return (struct receive){.typesel = typesel, .buf = buf, .room = (size_t)len};
}

static bool receive_is_complete(struct node *n, void *arg)
{
    return mailbox_complete(n, arg);
}

void node_crecv(long typesel, void *buf, long len);
void node_crecv(long typesel, void *buf, long len)
{
    struct node *n = enter_with("crecv", LOW(typesel));
    struct receive r = a_receive(n, LOW(typesel), buf, LOW(len));
    node_spend(n, n->sys->cfg->call_ps);
    mailbox_post(n, &r);
    node_order(n);
    node_wait(n, receive_is_complete, &r);
    mailbox_take(n, &r, "crecv");
    node_leave(n);
}

long node_irecv(long typesel, void *buf, long len);
long node_irecv(long typesel, void *buf, long len)
{
    struct node *n = enter_with("irecv", LOW(typesel));
    struct receive r = a_receive(n, LOW(typesel), buf, LOW(len));
    long id = new_id(n, false);
    node_spend(n, n->sys->cfg->call_ps);
    struct receive *posted = mailbox_id_receive(n, id);
    *posted = r;
    mailbox_post(n, posted);
    node_leave(n);
    return id;
}

void node_hrecv(long typesel, void *buf, long len, node_handler *handler);
void node_hrecv(long typesel, void *buf, long len, node_handler *handler)
{
    struct node *n = enter_with("hrecv", LOW(typesel));
    struct receive r = a_receive(n, LOW(typesel), buf, LOW(len));
    if (!handler)
        node_fail(n, "hrecv: the handler is a null pointer");
    node_spend(n, n->sys->cfg->call_ps);
    mailbox_post_handler(n, r.typesel, r.buf, r.room, handler);
    node_leave(n);
}

/* --- ids --- */

static _Noreturn void no_such_id(struct node *n, long id)
{
    node_fail(n, "%s: %ld is no message id in use", n->call, id);
}

void node_msgwait(long id);
void node_msgwait(long id)
{
    struct node *n = enter_with("msgwait", LOW(id));
    struct receive *r = mailbox_id_receive(n, LOW(id));
    struct send *s = mailbox_id_send(n, LOW(id));
    if (!r && !s)
        no_such_id(n, LOW(id));
    node_spend(n, n->sys->cfg->call_ps);
    node_order(n);
    n->awaited = r ? (long)r->typesel : s->m ? (long)s->m->type : 0;
    if (r) {
        node_wait(n, receive_is_complete, r);
        mailbox_take(n, r, "msgwait");
    } else {
        node_wait(n, send_is_done, s);
    }
    mailbox_id_release(n, LOW(id));
    node_leave(n);
}

long node_msgdone(long id);
long node_msgdone(long id)
{
    struct node *n = enter_with("msgdone", LOW(id));
    struct receive *r = mailbox_id_receive(n, LOW(id));
    struct send *s = mailbox_id_send(n, LOW(id));
    if (!r && !s)
        no_such_id(n, LOW(id));
    bool done = r ? mailbox_complete(n, r) : s->done;
    node_spend(n, n->sys->cfg->call_ps);
    if (done && r)
        mailbox_take(n, r, "msgdone");
    if (done)
        mailbox_id_release(n, LOW(id));
    node_leave(n);
    return done;
}

void node_msgcancel(long id);
void node_msgcancel(long id)
{
    struct node *n = enter_with("msgcancel", LOW(id));
    struct receive *r = mailbox_id_receive(n, LOW(id));
    if (!r && !mailbox_id_send(n, LOW(id)))
        no_such_id(n, LOW(id));
    node_spend(n, n->sys->cfg->call_ps);
    if (r)
        mailbox_withdraw(n, r);
    mailbox_id_release(n, LOW(id));
    node_leave(n);
}

/* --- probing --- */

static bool probe(struct node *n, long typesel)
{
    const struct message *m = mailbox_probe(n, typesel);
    if (m)
        n->info = (struct node_info){(long)m->type, (long)m->bytes, m->source, (long)m->pid};
    return m;
}

static bool probe_finds(struct node *n, void *arg)
{
    return probe(n, *(long *)arg);
}

void node_cprobe(long typesel);
void node_cprobe(long typesel)
{
    struct node *n = enter_with("cprobe", LOW(typesel));
    long selected = LOW(typesel);
    node_spend(n, n->sys->cfg->call_ps);
    node_order(n);
    node_wait(n, probe_finds, &selected);
    node_leave(n);
}

long node_iprobe(long typesel);
long node_iprobe(long typesel)
{
    struct node *n = enter_with("iprobe", LOW(typesel));
    node_spend(n, n->sys->cfg->call_ps);
    bool found = probe(n, LOW(typesel));
    node_leave(n);
    return found;
}

/* --- information: nothing of the outside matters, so no order is needed --- */

long node_infocount(void);
long node_infocount(void)
{
    return node_self()->info.count;
}

long node_infonode(void);
long node_infonode(void)
{
    return node_self()->info.node;
}

long node_infopid(void);
long node_infopid(void)
{
    return node_self()->info.pid;
}

long node_infotype(void);
long node_infotype(void)
{
    return node_self()->info.type;
}

long node_mynode(void);
long node_mynode(void)
{
    return node_self()->id;
}

long node_numnodes(void);
long node_numnodes(void)
{
    return node_self()->sys->count;
}

long node_mypid(void);
long node_mypid(void)
{
    return 0;
}

long node_myhost(void);
long node_myhost(void)
{
    return node_self()->sys->count;
}

long node_nodedim(void);
long node_nodedim(void)
{
    long d = 0;
    while ((UINT32_C(1) << d) < node_self()->sys->count)
        d++;
    return d;
}

/* --- clocks and the processor --- */

static vtime read_clock(const char *call)
{
    struct node *n = enter(call);
    node_spend(n, n->sys->cfg->clock_call_ps);
    vtime now = node_now(n);
    node_leave(n);
    return now;
}

unsigned long node_mclock(void);
unsigned long node_mclock(void)
{
    return (unsigned long)(read_clock("mclock") / VT_MILLISECOND);
}

double node_dclock(void);
double node_dclock(void)
{
    return vt_seconds(read_clock("dclock"));
}

void node_flick(void);
void node_flick(void)
{
    struct node *n = enter("flick");
    node_spend(n, n->sys->cfg->call_ps);
    node_leave(n);
}

long node_masktrap(long state);
long node_masktrap(long state)
{
    struct node *n = enter("masktrap");
    long before = n->masked;
    node_spend(n, n->sys->cfg->clock_call_ps);
    n->masked = LOW(state) != 0;
    if (before && !n->masked)
        n->open_since = node_now(n);
    node_order(n);
    while (node_run_handlers(n))
        node_order(n);
    node_leave(n);
    return before;
}

/* --- ending --- */

static void end_other(struct node *n, struct node *victim)
{
    if (victim->state == NODE_ENDED)
        return;
    victim->state = NODE_ENDED;
    victim->end = NODE_KILLED;
    victim->stats.ended_at = node_now(n);
    n->sys->running--;
}

void node_killcube(long node, long pid);
void node_killcube(long node, long pid)
{
    struct node *n = enter("killcube");
    (void)node, (void)pid;
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (i != n->id)
            end_other(n, n->sys->nodes[i]);
    n->sys->stop = STOP_KILLED;
    node_end_here(n, NODE_KILLED, 0);
}

void node_killproc(long node, long pid);
void node_killproc(long node, long pid)
{
    struct node *n = enter("killproc");
    long which = LOW(node);
    if (which == ALL_NODES)
        node_killcube(node, pid);
    if (which < 0 || which >= (long)n->sys->count)
        node_fail(n, "killproc: there is no node %ld (nodes are 0 to %u; -1 is all)", which,
                  n->sys->count - 1);
    if (which == n->id)
        node_end_here(n, NODE_KILLED, 0);
    end_other(n, n->sys->nodes[which]);
    node_spend(n, n->sys->cfg->call_ps);
    node_leave(n);
}
