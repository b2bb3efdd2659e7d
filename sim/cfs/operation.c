/* operation.c - see operation.h.
 *
 *   op     a call: a range of a file. In modes 1 and 2 the directory is asked first where the range begins.
 *   piece  the part of the range that lies in one block: a request to the block's I/O node, and its answer.
 *
 * At most cfg.window_blocks pieces per disk are under way; each answer lets the next one leave. The first
 * pieces leave from the call, the others from the interrupts of the answers, at the cost of the node's
 * processor (node_work).
 *
 *   read piece   node -- request, eager --> I/O node     write piece   node -- data, rendezvous --> I/O node
 *                     <--- data, eager ---                                  <----- done, eager ----
 */
#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include "cfs/cfs_state.h"
#include "cfs/operation.h"
#include "kernel/xalloc.h"
#include "lp/engine.h"
#include "os/charge.h"
#include "os/fail.h"
#include "os/front.h"
#include "os/gate.h"

enum { READ_REQUEST = 64 }; /* bytes: file, block, offset, length */

struct piece {
    struct parcel parcel; /* first */
    struct io_request request;
    struct cfs_op *op;
    struct message *request_to_send; /* of a write that waits for room */
};

struct cfs_op {
    struct dir_request pointer; /* first; modes 1 and 2 */
    struct cfs *cfs;
    struct node *node;
    struct store_file *store;
    bool write, shared;
    struct round *round; /* mode 4, and this call serves all */
    uint64_t at, bytes;
    char *data;
    struct iovec *parts; /* of the program's memory */
    int part_count;
    struct piece *pieces;
    uint32_t count, issued, answered;
    bool done;
    vtime complete; /* when done: from then on */
    struct cfs_op *next, **link;
};

/* --- making and ending --- */

static void op_free(struct cfs_op *op)
{
    if (op->next)
        op->next->link = op->link;
    *op->link = op->next;
    free(op->pieces);
    free(op->parts);
    free(op->data);
    free(op);
}

static uint64_t sum_of(const struct iovec *parts, int count)
{
    uint64_t bytes = 0;
    for (int i = 0; i < count; i++)
        bytes += parts[i].iov_len;
    return bytes;
}

static struct cfs_op *op_new(struct cfs_file *f, bool write, const struct iovec *parts, int count)
{
    struct cfs *c = f->cfs;
    struct cfs_op *op = xcalloc(1, sizeof *op);
    *op = (struct cfs_op){.cfs = c, .node = f->base.node, .store = f->store, .write = write};
    op->shared = f->mode != MODE_OWN && f->mode != MODE_ASYNC;
    op->part_count = count;
    op->parts = xmalloc((size_t)count * sizeof *parts + 1);
    op->bytes = sum_of(parts, count);
    if (write)
        op->data = xmalloc(op->bytes + 1);
    char *to = op->data;
    for (int i = 0; i < count; i++) {
        op->parts[i] = parts[i];
        if (write && parts[i].iov_len)
            to = (char *)memcpy(to, parts[i].iov_base, parts[i].iov_len) + parts[i].iov_len;
    }
    store_hold(f->store);
    op->next = c->ops, op->link = &c->ops;
    if (op->next)
        op->next->link = &op->next;
    c->ops = op;
    return op;
}

void cfs_free_ops(struct cfs *c)
{
    while (c->ops)
        op_free(c->ops);
}

/* All pieces are answered. If the program has ended meanwhile, nobody else ends the op. */
static void finish(struct cfs_op *op, vtime at)
{
    assert(!op->done && op->answered == op->issued);
    op->done = true;
    op->complete = at;
    if (op->round)
        unison_spread(op->round, op->node->id, op->bytes, op->data, at);
    store_release(op->store);
    if (op->node->lp.state == LP_ENDED)
        op_free(op);
    else
        lp_wake(&op->node->lp, at);
}

void cfs_told(struct cfs_op *op, uint64_t bytes, const char *data, vtime at)
{
    op->bytes = bytes;
    if (!op->write)
        op->data = memcpy(xmalloc(bytes + 1), data, bytes);
    finish(op, at);
}

bool cfs_done(struct node *n, const struct cfs_op *op)
{
    return op->done && op->complete <= node_now(n);
}

static bool is_done(struct node *n, void *op)
{
    return cfs_done(n, op);
}

void cfs_wait(struct node *n, struct cfs_op *op)
{
    node_order(n);
    if (op->done && !cfs_done(n, op))
        lp_wake(&n->lp, op->complete);
    node_wait(n, is_done, op);
}

ssize_t cfs_end(struct cfs_op *op)
{
    if (!op->write) /* into the program's memory; what is written has been copied when the call began */
        node_spend(op->node, op->bytes * op->cfs->cfg->client_ps_per_byte);
    ssize_t moved = (ssize_t)op->bytes;
    const char *from = op->data;
    uint64_t left = op->write ? 0 : op->bytes;
    for (int i = 0; i < op->part_count && left > 0; i++) {
        size_t n = op->parts[i].iov_len < left ? op->parts[i].iov_len : left;
        memcpy(op->parts[i].iov_base, from, n);
        from += n, left -= n;
    }
    op_free(op);
    return moved;
}

/* --- pieces --- */

static size_t request_bytes(const struct piece *p)
{
    return p->op->write ? POST_HEADER + p->request.piece.bytes : READ_REQUEST;
}

static enum post_kind request_kind(const struct piece *p)
{
    return p->op->write ? POST_RENDEZVOUS : POST_EAGER;
}

static struct ionode *ionode_of(const struct piece *p)
{
    return p->op->cfs->io[p->request.piece.disk % p->op->cfs->cfg->io_nodes];
}

static uint32_t address_of(const struct piece *p)
{
    return p->op->cfs->first_address + (uint32_t)(p->request.piece.disk % p->op->cfs->cfg->io_nodes);
}

/* At the I/O node: is there room for the data of a write? */
static bool has_room(struct parcel *parcel, struct message *m, vtime now)
{
    struct piece *p = (struct piece *)parcel;
    if (ionode_reserve(ionode_of(p), &p->request, now))
        return true;
    p->request_to_send = m;
    return false;
}

void cfs_room(void *ctx, struct io_request *r, vtime now)
{
    struct piece *p = (struct piece *)((char *)r - offsetof(struct piece, request));
    (void)ctx;
    protocol_clear_to_send(p->request_to_send->protocol, p->request_to_send, now);
}

static void request_arrived(struct parcel *parcel, vtime at, vtime now)
{
    struct piece *p = (struct piece *)parcel;
    (void)now;
    ionode_request(ionode_of(p), &p->request, at);
}

static vtime issue_time(const struct cfs_op *op)
{
    const struct piece *p = &op->pieces[op->issued];
    return post_send_time(op->cfs->sys->schedule.protocol, request_kind(p), request_bytes(p));
}

/* The next piece leaves its node at `at`. */
static void issue(struct cfs_op *op, vtime at)
{
    assert(op->issued < op->count);
    struct piece *p = &op->pieces[op->issued++];
    p->parcel = (struct parcel){.has_room = has_room, .arrived = request_arrived};
    post_send(op->cfs->sys->schedule.protocol, op->node->id, address_of(p), request_kind(p), request_bytes(p),
              &p->parcel, at);
}

/* At the node: a piece is read, or written. */
static void answer_arrived(struct parcel *parcel, vtime at, vtime now)
{
    struct cfs_op *op = ((struct piece *)parcel)->op;
    (void)now;
    op->answered++;
    assert(op->answered <= op->issued);
    op->complete = vt_max(op->complete, at);
    if (op->issued < op->count && op->node->lp.state != LP_ENDED)
        issue(op, node_work(op->cfs->sys, op->node->id, PROTOCOL_SEND, at, issue_time(op)));
    if (op->answered == op->issued)
        finish(op, op->complete);
}

/* At the I/O node: the answer leaves. */
void cfs_answer(void *ctx, struct io_request *r, vtime now)
{
    struct cfs *c = ctx;
    struct piece *p = (struct piece *)((char *)r - offsetof(struct piece, request));
    size_t bytes = POST_HEADER + (r->write ? 0 : r->piece.bytes);
    vtime at = ionode_work(ionode_of(p), now, post_send_time(c->sys->schedule.protocol, POST_EAGER, bytes));
    *(r->write ? &c->bytes_written : &c->bytes_read) += r->piece.bytes;
    p->parcel.arrived = answer_arrived;
    post_send(c->sys->schedule.protocol, address_of(p), p->op->node->id, POST_EAGER, bytes, &p->parcel, at);
}

/* The op's range is known: makes the pieces, and room for what a read brings, which may ask for far more than
 * there is. */
static void cut(struct cfs_op *op)
{
    if (!op->write)
        op->data = xmalloc(op->bytes + 1);
    const struct store_file *f = op->store;
    uint32_t block = (uint32_t)op->cfs->cfg->block_bytes;
    uint64_t first = op->at / block, end = (op->at + op->bytes + block - 1) / block, done = 0;
    op->count = op->bytes ? (uint32_t)(end - first) : 0;
    op->pieces = xcalloc(op->count + 1, sizeof *op->pieces);
    for (uint32_t i = 0; i < op->count; i++) {
        struct piece *p = &op->pieces[i];
        p->op = op;
        p->request = (struct io_request){.write = op->write,
                                         .node = op->node->id,
                                         .file = op->store,
                                         .stride = f->volume_count,
                                         .shared = op->shared,
                                         .data = op->data + done};
        p->request.piece = stripe_first(f->volumes, f->volume_count, block, op->at + done, op->bytes - done);
        done += p->request.piece.bytes;
    }
}

static uint32_t window(const struct cfs_op *op)
{
    uint64_t most = op->cfs->cfg->window_blocks * op->store->volume_count;
    return op->count < most ? op->count : (uint32_t)most;
}

/* The first pieces leave, from the call. */
static void go(struct cfs_op *op)
{
    cut(op);
    for (uint32_t first = window(op); op->issued < first;) {
        node_spend_on(op->node, NODE_SENDING, issue_time(op));
        issue(op, node_now(op->node));
    }
    if (op->count == 0)
        finish(op, node_now(op->node));
}

/* The first pieces leave, from an interrupt, at `at` or when the processor is free. */
static void go_later(struct cfs_op *op, vtime at)
{
    cut(op);
    for (uint32_t first = window(op); op->issued < first;)
        issue(op, node_work(op->cfs->sys, op->node->id, PROTOCOL_SEND, at, issue_time(op)));
    if (op->count == 0)
        finish(op, at);
}

/* --- shared pointers, modes 1 and 2: at the directory --- */

static struct modes_group *group_of(const struct cfs_op *op, int mode)
{
    return &op->store->modes.group[mode];
}

static void take_position(struct cfs_op *op, int mode)
{
    struct modes_group *g = group_of(op, mode);
    if (!op->write)
        op->bytes = cfs_readable(op->store, g->at, op->bytes);
    op->at = modes_take(g, op->bytes);
}

static bool serve_first_come(struct dir_request *r, vtime now)
{
    (void)now;
    take_position((struct cfs_op *)r, MODE_FIRST_COME);
    return true;
}

/* Takes the first waiting call of the node whose turn it is off the list. NULL: there is none. */
static struct dir_request *whose_turn(struct store_file *f)
{
    struct dir_request **link = &f->waiting;
    while (*link && (*link)->node != f->modes.group[MODE_ORDERED].turn)
        link = &(*link)->next;
    struct dir_request *r = *link;
    if (r)
        *link = r->next;
    return r;
}

static bool serve_ordered(struct dir_request *r, vtime now)
{
    struct cfs_op *op = (struct cfs_op *)r;
    struct store_file *f = op->store;
    uint32_t nodes = op->cfs->sys->count;
    struct dir_request **end = &f->waiting;
    while (*end)
        end = &(*end)->next;
    r->next = NULL;
    *end = r;
    while ((r = whose_turn(f))) {
        take_position((struct cfs_op *)r, MODE_ORDERED);
        modes_next_turn(&f->modes.group[MODE_ORDERED], nodes);
        directory_answer(r->directory, r, now);
    }
    return false;
}

static void pointer_comes(struct dir_request *r, vtime at, vtime now)
{
    (void)now;
    go_later((struct cfs_op *)r, at);
}

static void ask_position(struct cfs_op *op, int mode)
{
    struct cfs *c = op->cfs;
    op->pointer = (struct dir_request){.node = op->node->id,
                                       .takes = c->cfg->pointer_ps,
                                       .serve = mode == MODE_ORDERED ? serve_ordered : serve_first_come,
                                       .answered = pointer_comes};
    node_spend_on(op->node, NODE_SENDING, directory_ask_time(c->directory));
    directory_ask(c->directory, &op->pointer, node_now(op->node));
}

/* --- starting --- */

/* Mode 3: the node itself knows where its record is. */
static void position_record(struct cfs_file *f, struct cfs_op *op)
{
    struct node *n = op->node;
    const uint64_t *sought = cfs_has_sought(f) ? &f->at : NULL;
    const struct modes_round r = modes_record(cfs_group(f), f->round++, n->sys->count, sought, op->bytes);
    if (r.bytes != op->bytes)
        node_fail(n, "%s: in I/O mode 3 all nodes give the same length: %lu bytes here, %lu elsewhere (%s)",
                  n->call.name, op->bytes, r.bytes, f->store->path);
    if (sought && r.start != *sought)
        node_fail(n, "%s: in I/O mode 3 all nodes seek to the same place: to %lu here, %lu elsewhere (%s)",
                  n->call.name, *sought, r.start, f->store->path);
    op->at = r.start + n->id * op->bytes;
    if (!op->write)
        op->bytes = cfs_readable(op->store, op->at, op->bytes);
}

static void position_own(struct cfs_file *f, struct cfs_op *op)
{
    if (op->write && (f->flags & O_APPEND))
        f->at = f->store->size;
    if (!op->write)
        op->bytes = cfs_readable(op->store, f->at, op->bytes);
    op->at = f->at;
    f->at += op->bytes;
}

/* Mode 4: the first node's call is as in mode 0, the others' calls wait for its result. */
static void start_unison(struct cfs_file *f, struct cfs_op *op)
{
    struct node *n = op->node;
    const struct round_call call = {op->write, f->at, op->bytes};
    struct round_call other;
    bool first;
    struct round *r = unison_join(f, &call, &first, &other);
    if (!r)
        node_fail(n,
                  "%s: in I/O mode 4 all nodes give the same calls: a %s of %lu bytes at %lu here, "
                  "a %s of %lu at %lu elsewhere (%s)",
                  n->call.name, call.write ? "write" : "read", call.asked, call.at,
                  other.write ? "write" : "read", other.asked, other.at, f->store->path);
    if (first) {
        op->round = r;
        position_own(f, op);
        *unison_pointer(r) = f->at;
        go(op);
    } else {
        f->at = *unison_pointer(r);
        unison_await(r, n->id, op, node_now(n));
    }
}

/* Modes in which a call depends on the other nodes' calls. Returns false in other modes. */
static bool start_shared(struct cfs_file *f, struct cfs_op *op)
{
    if (f->mode == MODE_FIRST_COME || f->mode == MODE_ORDERED)
        ask_position(op, f->mode);
    else if (f->mode == MODE_UNISON)
        start_unison(f, op);
    else
        return false;
    return true;
}

/* The call names an offset: no pointer is used. */
static void position_at(struct cfs_op *op, uint64_t at)
{
    if (!op->write)
        op->bytes = cfs_readable(op->store, at, op->bytes);
    op->shared = false;
    op->at = at;
}

struct cfs_op *cfs_start(struct cfs_file *f, bool write, int64_t at, const struct iovec *parts, int count)
{
    struct node *n = f->base.node;
    int access = f->flags & O_ACCMODE;
    uint64_t written = write ? sum_of(parts, count) : 0;
    node_spend(n, n->sys->cfg->call_ps + f->cfs->cfg->client_ps + written * f->cfs->cfg->client_ps_per_byte);
    node_order(n);
    bool may = access == O_RDWR || access == (write ? O_WRONLY : O_RDONLY);
    if (!may || written > INT64_MAX - (at < 0 ? f->at : (uint64_t)at)) {
        errno = may ? EFBIG : EBADF;
        return NULL;
    }
    struct cfs_op *op = op_new(f, write, parts, count);
    if (at < 0 && start_shared(f, op))
        return op;
    if (at >= 0)
        position_at(op, (uint64_t)at);
    else if (f->mode == MODE_RECORDS)
        position_record(f, op);
    else
        position_own(f, op);
    go(op);
    return op;
}
