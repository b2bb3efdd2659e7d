/* shared_pointer.c - see shared_pointer.h. A node sends one request at a time to another's library, and waits
 * for the answer without running handlers. */
#include "nx_api/mpi/shared_pointer.h"
#include <stdlib.h>
#include <string.h>
#include "nx_api/calls/call.h"
#include "nx_api/mpi/mpi_wire.h"

enum what { BORROW, LENT, GIVEN_BACK, TOKEN, ROUND, CHECKED };

/* The contents of each of these messages. */
struct note {
    int64_t offset, bytes; /* ROUND: offset is the round's number */
};

/* On node 0: an M_LOG pointer that has been requested, or an M_RECORD round that is not complete. On any
 * node: the M_SYNC pointer while it is here. */
struct keep {
    struct keep *next;
    enum what what; /* BORROW, ROUND, TOKEN */
    int32_t number;
    struct note note;
    uint32_t heard;   /* ROUND: from how many nodes */
    long first;       /* ROUND: the first of them */
    bool lent;        /* BORROW */
    uint32_t waiting; /* how many, in the order of asking */
    int32_t *queue;   /* as many as there are nodes */
};

static struct keep *kept;
static bool answered;
static struct note answer;

static struct keep *find(enum what what, int32_t number, int64_t round)
{
    struct keep *k = kept;
    while (k && (k->what != what || k->number != number || (what == ROUND && k->note.offset != round)))
        k = k->next;
    return k;
}

static struct keep *keep(struct node *n, enum what what, int32_t number, struct note note)
{
    struct keep *k = calloc(1, sizeof *k);
    if (!k || !(k->queue = calloc(n->sys->count, sizeof *k->queue)))
        node_fail(n, "out of memory");
    k->what = what, k->number = number, k->note = note;
    k->next = kept;
    kept = k;
    return k;
}

static void forget(struct keep *k)
{
    struct keep **link = &kept;
    while (*link != k)
        link = &(*link)->next;
    *link = k->next;
    free(k->queue);
    free(k);
}

static void tell(struct node *n, long node, enum what what, int32_t number, struct note note)
{
    wire_send(n, node, (struct wire_head){WIRE_FILES, what, number, 0}, &note, sizeof note);
}

/* --- node 0's side --- */

static void lend(struct node *n, struct keep *k)
{
    if (k->lent || !k->waiting)
        return;
    int32_t to = k->queue[0];
    k->lent = true;
    memmove(k->queue, k->queue + 1, --k->waiting * sizeof *k->queue);
    tell(n, to, LENT, k->number, k->note);
}

static void ask_for(struct node *n, int source, int32_t number, struct note note)
{
    struct keep *k = find(BORROW, number, 0);
    if (!k)
        k = keep(n, BORROW, number, note);
    k->queue[k->waiting++] = source;
    lend(n, k);
}

static void take_back(struct node *n, int32_t number, struct note note)
{
    struct keep *k = find(BORROW, number, 0);
    k->note = note;
    k->lent = false;
    lend(n, k);
}

static void check_round(struct node *n, int source, int32_t number, struct note note)
{
    struct keep *k = find(ROUND, number, note.offset);
    if (!k) {
        k = keep(n, ROUND, number, note);
        k->first = source;
    }
    if (k->note.bytes != note.bytes)
        node_fail(n, "I/O modes 3 and 4: node %d gives %lld bytes in a round for which node %ld gave %lld",
                  source, (long long)note.bytes, k->first, (long long)k->note.bytes);
    if (++k->heard == n->sys->count)
        forget(k);
    tell(n, source, CHECKED, number, note);
}

void shared_message(struct node *n, int source, int32_t what, int32_t number, const void *bytes)
{
    struct note note;
    memcpy(&note, bytes, sizeof note);
    switch ((enum what)what) {
    case BORROW:
        ask_for(n, source, number, note);
        break;
    case GIVEN_BACK:
        take_back(n, number, note);
        break;
    case ROUND:
        check_round(n, source, number, note);
        break;
    case TOKEN:
        keep(n, TOKEN, number, note);
        break;
    case LENT:
    case CHECKED:
        answered = true;
        answer = note;
        break;
    }
}

/* --- the program's side --- */

static bool is_answered(struct node *n, void *unused)
{
    (void)n, (void)unused;
    return answered;
}

static bool has_token(struct node *n, void *number)
{
    (void)n;
    return find(TOKEN, *(int32_t *)number, 0);
}

bool shared_is_awaited(bool (*ready)(struct node *n, void *arg))
{
    return ready == is_answered || ready == has_token;
}

static void wait_for(struct node *n, bool (*ready)(struct node *, void *), void *arg)
{
    bool before = n->in_handler;
    n->in_handler = true;
    node_wait(n, ready, arg);
    n->in_handler = before;
}

static struct note request(struct node *n, enum what what, int32_t number, struct note note)
{
    answered = false;
    tell(n, 0, what, number, note);
    wait_for(n, is_answered, NULL);
    return answer;
}

int64_t shared_borrow(struct node *n, int mode, int32_t number, int64_t begin)
{
    if (mode == M_LOG)
        return request(n, BORROW, number, (struct note){begin, 0}).offset;
    wait_for(n, has_token, &number);
    struct keep *k = find(TOKEN, number, 0);
    int64_t offset = k->note.offset;
    forget(k);
    return offset;
}

void shared_start(struct node *n, int32_t number, int64_t offset)
{
    keep(n, TOKEN, number, (struct note){offset, 0});
}

void shared_give_back(struct node *n, int mode, int32_t number, int64_t offset)
{
    const struct note note = {offset, 0};
    if (mode == M_LOG)
        tell(n, 0, GIVEN_BACK, number, note);
    else
        tell(n, (n->id + 1) % n->sys->count, TOKEN, number, note);
}

void shared_check(struct node *n, int32_t number, int64_t round, int64_t bytes)
{
    request(n, ROUND, number, (struct note){round, bytes});
}
