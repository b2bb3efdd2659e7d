/* waitfor_reason.c - the cause of each wait in sentences, and what to do about it. */
#include <inttypes.h>
#include <stdlib.h>
#include "nx_api/waitfor/waitfor_mpi.h"
#include "nx_api/waitfor/waitfor_parts.h"

enum { MOST_TOLD = 4 }; /* messages of one node */

/* What reasons of many nodes have in common: each part is found once. */
struct reasons {
    struct waitfor *w;
    struct waitfor_set living, ended; /* ended: but for the host, for which no global operation waits */
    struct missed {
        const char *operation, *text; /* whom it waits for */
    } * missed;
    size_t missed_count;
};

static void print_wanted(FILE *f, const struct waitfor *w, const struct waitfor_select *s)
{
    if (waitfor_is_mpi(s->pid)) {
        waitfor_print_mpi(f, w, s->typesel, s->node, s->pid);
        return;
    }
    waitfor_print_typesel(f, s->typesel);
    fputs(" from ", f);
    waitfor_print_node(f, w, s->node);
    if (s->pid != WAITFOR_ANY)
        fprintf(f, ", process type %ld", s->pid);
}

/* --- what is here --- */

/* In what a message that is here differs from one that is selected. */
static void print_difference(FILE *f, const struct waitfor *w, const struct waitfor_node *n,
                             const struct waitfor_message *m)
{
    const struct waitfor_select *s = &n->select;
    bool type = !waitfor_type_selected(s->typesel, m->type);
    bool node = s->node != WAITFOR_ANY && s->node != m->from;
    bool pid = s->pid != WAITFOR_ANY && s->pid != m->pid;
    if (waitfor_is_mpi(s->pid) && (type || node || pid)) {
        fputs(" (it wants ", f);
        print_wanted(f, w, s);
        fputc(')', f);
        return;
    }
    fputs(type || node || pid ? " (it wants " : "", f);
    if (type)
        waitfor_print_typesel(f, s->typesel);
    fputs(type && node ? " from " : "", f);
    if (node)
        waitfor_print_node(f, w, s->node);
    if (pid)
        fprintf(f, "%sprocess type %ld, not %ld", type || node ? ", " : "", s->pid, m->pid);
    fputs(type || node || pid ? ")" : m->held_back ? " (there is no room for it)" : "", f);
}

static void print_messages(FILE *f, const struct waitfor *w, const struct waitfor_node *n)
{
    uint64_t count = 0, told = 0;
    for (size_t i = 0; i < n->message_count; i++)
        count += waitfor_concerns(n, &n->messages[i]);
    if (!count) /* nor, most likely, those that are not listed */
        return;
    count += n->more_messages;
    if (count == 1)
        fputs("\n1 message is here: ", f);
    else
        fprintf(f, "\n%" PRIu64 " messages are here: ", count);
    for (size_t i = 0; i < n->message_count && told < MOST_TOLD; i++) {
        const struct waitfor_message *m = &n->messages[i];
        if (!waitfor_concerns(n, m))
            continue;
        fputs(told++ ? ", " : "", f);
        print_wanted(
            f, w, &(struct waitfor_select){m->type, m->from, waitfor_is_mpi(m->pid) ? m->pid : WAITFOR_ANY});
        print_difference(f, w, n, m);
    }
    if (count > told)
        fprintf(f, ", and %" PRIu64 " more", count - told);
    fputc('.', f);
}

/* --- what has been here --- */

/* "crecv(-1) at ring.c:17" */
static void print_receive(FILE *f, const struct waitfor *w, const char *call, const struct waitfor_select *s)
{
    fprintf(f, "%s(%ld)", call ? call : "a receive", s->typesel);
    if (s->node != WAITFOR_ANY) {
        fputs(" from ", f);
        waitfor_print_node(f, w, s->node);
    }
}

static void print_line(FILE *f, const char *line)
{
    if (line)
        fprintf(f, " at %s", line);
}

static void print_fate(FILE *f, const struct waitfor *w, const struct waitfor_taken *t)
{
    if (t->fate == WAITFOR_FLUSHED) {
        fputs("flushmsg threw it away.", f);
        return;
    }
    if (t->fate == WAITFOR_DISCARDED) {
        fputs("NX threw it away, because its type is a forced one and no receive was posted for it.", f);
        return;
    }
    print_receive(f, w, t->call, &t->by);
    if (t->fate == WAITFOR_HANDLED)
        fputs(" with its handler", f);
    print_line(f, t->line);
    fputs(" took it.", f);
}

static void print_held(FILE *f, const struct waitfor *w, const struct waitfor_receive *r)
{
    fprintf(f, "\nA message of type %ld from ", r->type);
    waitfor_print_node(f, w, r->from);
    fputs(" is here: ", f);
    print_receive(f, w, "irecv", &r->select);
    print_line(f, r->line);
    fputs(" has it, and the program has not waited for its id.", f);
}

static void print_taken(FILE *f, const struct waitfor *w, const struct waitfor_node *n)
{
    const struct waitfor_receive *r = waitfor_held_by(n);
    const struct waitfor_taken *t = waitfor_taken_away(n);
    if (r) {
        print_held(f, w, r);
    } else if (t) {
        fputs("\nA message of ", f);
        print_wanted(
            f, w, &(struct waitfor_select){t->type, t->from, waitfor_is_mpi(t->pid) ? t->pid : WAITFOR_ANY});
        fputs(" came", f);
        if (t->came_ps != WAITFOR_NEVER) {
            fputs(" at ", f);
            waitfor_print_time(f, t->came_ps);
        }
        fputs(": ", f);
        print_fate(f, w, t);
    }
}

static void print_masked(FILE *f, const struct waitfor *w, const struct waitfor_node *n)
{
    bool one = n->due == 1;
    fprintf(f, "\n%" PRIu32 " handler%s due and do%s not run", n->due, one ? " is" : "s are",
            one ? "es" : "");
    for (size_t i = 0; i < n->receive_count; i++) {
        const struct waitfor_receive *r = &n->receives[i];
        if (!r->has_handler || !r->filled)
            continue;
        fputs(", that of ", f);
        print_receive(f, w, "hrecv", &r->select);
        print_line(f, r->line);
        fprintf(f, " for type %ld from ", r->type);
        waitfor_print_node(f, w, r->from);
    }
    fputs(n->masked ? ": masktrap has masked handlers." : ": the program waits inside of another handler.",
          f);
}

/* --- for whom it waits --- */

static bool is_missed_and_lives(const struct waitfor *w, uint32_t i, const void *operation)
{
    return waitfor_is_missed(w, i, operation) && waitfor_lives(&w->nodes[i]);
}

static bool lives(const struct waitfor *w, uint32_t i, const void *arg)
{
    (void)arg;
    return waitfor_lives(&w->nodes[i]);
}

static bool has_ended(const struct waitfor *w, uint32_t i, const void *arg)
{
    (void)arg;
    return !w->nodes[i].is_host && !waitfor_lives(&w->nodes[i]);
}

static void print_missed(FILE *f, const struct reasons *r, const char *operation)
{
    struct waitfor_set missed = waitfor_choose(r->w, is_missed_and_lives, operation);
    fprintf(f, "%s waits for ", operation);
    if (missed.nodes) {
        waitfor_print_set(f, &missed, WAITFOR_ANY);
        fputs(" to come to it", f);
    }
    if (r->ended.nodes) {
        fputs(missed.nodes ? ", and for " : "", f);
        waitfor_print_set(f, &r->ended, WAITFOR_ANY);
        fputs(", which ended without it", f);
    }
    fputc('.', f);
    free(missed.runs);
}

/* ", which waits, too" */
static void print_end(FILE *f, const struct waitfor_node *whom)
{
    fputs(", which ", f);
    waitfor_print_ended(f, whom);
    fputs(" at ", f);
    waitfor_print_time(f, whom->since_ps);
}

static void print_state(FILE *f, const struct waitfor_node *n, const struct waitfor_node *whom)
{
    if (whom == n)
        fputs(", which is itself", f);
    else if (whom->state == WAITFOR_WAITS)
        fputs(", which waits, too", f);
    else if (whom->state == WAITFOR_COMPUTES)
        fputs(", which computes", f);
    else if (whom->state == WAITFOR_ENDED)
        print_end(f, whom);
    else
        fputs(", on which no program runs", f);
}

/* Is it the host, and has it loaded no program? */
static bool is_alone(const struct waitfor *w, const struct waitfor_node *n)
{
    for (uint32_t i = 0; i < w->count; i++)
        if (&w->nodes[i] != n && w->nodes[i].state != WAITFOR_NO_PROGRAM)
            return false;
    return n->is_host;
}

static void print_any(FILE *f, const struct reasons *r, const struct waitfor_node *n)
{
    uint32_t living = r->living.nodes + (r->living.host != WAITFOR_ANY);
    if (is_alone(r->w, n)) {
        fputs(", and no node has a program.", f);
        return;
    }
    if (living == 1) {
        fputs(", and all other nodes have ended.", f);
        return;
    }
    fputs("; ", f);
    if (living < r->w->count)
        waitfor_print_set(f, &r->living, n->number);
    else
        fputs("each other node", f);
    fputs(" could send it, but none has.", f);
}

static void print_message_wait(FILE *f, const struct reasons *r, const struct waitfor_node *n)
{
    const struct waitfor *w = r->w;
    fputs("It waits for ", f);
    if (n->is_locked) {
        waitfor_print_lock(f, w, n);
        print_state(f, n, &w->nodes[n->holder]);
        fputc('.', f);
        return;
    }
    print_wanted(f, w, &n->select);
    if (waitfor_lacks_host(w, n)) {
        fputs(", which would be the host, and there is none.", f);
        return;
    }
    if (n->who != WAITFOR_ONE_NODE) {
        print_any(f, r, n);
        return;
    }
    bool any = n->select.node == WAITFOR_ANY;
    if (any) {
        fputs("; only ", f);
        waitfor_print_node(f, w, n->whom);
    }
    print_state(f, n, &w->nodes[n->whom]);
    fputs(any ? ", could send it." : ".", f);
}

static void print_buffer_wait(FILE *f, const struct waitfor *w, const struct waitfor_node *n)
{
    const struct waitfor_node *to = n->who == WAITFOR_ONE_NODE ? &w->nodes[n->whom] : NULL;
    fprintf(f, "Its message of %zu bytes has no %s at ", n->to_bytes, n->to_held ? "receive" : "room");
    waitfor_print_node(f, w, n->to);
    if (to)
        print_state(f, n, to);
    fputc('.', f);
    if (n->to_held)
        fputs("\nA synchronous send, or one of more bytes than mpi_eager_limit, waits for its receive.", f);
    else if (to && to->buffer_bytes)
        fprintf(f, "\nThat has %zu bytes of messages that no receive has asked for, and room for %zu in all.",
                to->buffered_bytes, to->buffer_bytes);
}

static void print_end_wait(FILE *f, const struct waitfor *w, const struct waitfor_node *n)
{
    fputs("It waits for the end of the program on ", f);
    if (n->to == WAITFOR_ANY)
        fputs(n->of_all ? "each other node" : "another node", f);
    else
        waitfor_print_node(f, w, n->to);
    if (n->to != WAITFOR_ANY && n->who == WAITFOR_ONE_NODE)
        print_state(f, n, &w->nodes[n->whom]);
    fputc('.', f);
}

static void print_wait(FILE *f, const struct reasons *r, const struct waitfor_node *n)
{
    if (n->what == WAITFOR_MESSAGE)
        print_message_wait(f, r, n);
    else if (n->what == WAITFOR_BUFFER)
        print_buffer_wait(f, r->w, n);
    else if (n->what == WAITFOR_END)
        print_end_wait(f, r->w, n);
    else if (n->what == WAITFOR_HANDLER)
        fputs("It waits for a handler to run.", f);
    else if (n->what == WAITFOR_FILE)
        fputs("It waits for calls of other nodes on the file, whose pointer they share (I/O modes 1 to 4).",
              f);
}

/* --- all of it --- */

/* The sentence about a global operation, kept for the other nodes in it. */
static const char *missed_by(struct reasons *r, const char *operation)
{
    for (size_t k = 0; k < r->missed_count; k++)
        if (r->missed[k].operation == operation)
            return r->missed[k].text;
    char *text;
    size_t size;
    FILE *f = waitfor_stream(&text, &size);
    print_missed(f, r, operation);
    fclose(f);
    r->missed = waitfor_room(r->missed, r->missed_count, sizeof *r->missed);
    r->missed[r->missed_count] = (struct missed){operation, waitfor_text(r->w, text)};
    free(text);
    return r->missed[r->missed_count++].text;
}

static void print_why(FILE *f, struct reasons *r, const struct waitfor_node *n)
{
    if (n->operation)
        fputs(missed_by(r, n->operation), f);
    else
        print_wait(f, r, n);
    if (n->cause == WAITFOR_MASKED)
        print_masked(f, r->w, n);
    if (n->what != WAITFOR_MESSAGE || n->operation)
        return;
    if (n->cause == WAITFOR_TAKEN)
        print_taken(f, r->w, n);
    print_messages(f, r->w, n);
}

static const char *why(struct reasons *r, const struct waitfor_node *n)
{
    if (n->operation && n->cause != WAITFOR_MASKED)
        return missed_by(r, n->operation);
    char *text;
    size_t size;
    FILE *f = waitfor_stream(&text, &size);
    print_why(f, r, n);
    fclose(f);
    const char *kept = waitfor_text(r->w, text);
    free(text);
    return kept;
}

/* --- what to do --- */

static const char *remedy_for_taken(const struct waitfor_node *n)
{
    const struct waitfor_taken *t = waitfor_held_by(n) ? NULL : waitfor_taken_away(n);
    if (!t)
        return "msgwait on that id, or give the two receives different types.";
    switch (t->fate) {
    case WAITFOR_FLUSHED:
        return "flushmsg with fewer types, or before the message may come.";
    case WAITFOR_DISCARDED:
        return "Post the receive (irecv) before its sender sends, or use a type below 2^30.";
    default:
        return "Let the earlier receive select fewer types or nodes, or give the messages different types.";
    }
}

/* Does the cycle lead through global operations only? */
static bool is_of_operations(const struct waitfor *w)
{
    for (uint32_t k = 0; k < w->cycle_count; k++)
        if (!w->nodes[w->cycle[k]].operation)
            return false;
    return w->cycle_count > 0;
}

/* Which program's exit with an error came first, if one did; else NULL. */
static const char *remedy_for_exit(struct waitfor *w)
{
    const struct waitfor_node *first = NULL;
    for (uint32_t i = 0; i < w->count; i++)
        if (w->nodes[i].exit_status && (!first || w->nodes[i].since_ps < first->since_ps))
            first = &w->nodes[i];
    if (!first)
        return NULL;
    char text[120];
    snprintf(text, sizeof text, "Look at %s first: its program ended with exit(%d).", first->name,
             first->exit_status);
    return waitfor_text(w, text);
}

/* The first node that waits for a reason of its own, as its mailbox or a full one shows; NULL: none. In a
 * collective what the mailbox shows follows from which members have come. */
static const struct waitfor_node *waits_by_itself(const struct waitfor *w)
{
    for (uint32_t i = 0; i < w->count; i++) {
        const struct waitfor_node *n = &w->nodes[i];
        if (n->state == WAITFOR_WAITS && n->cause < WAITFOR_NODE_HAS_ENDED && !waitfor_in_collective(n))
            return n;
    }
    return NULL;
}

/* The advice to look at such a node first, and why; NULL: there is none. */
static const char *look_first(struct waitfor *w, const char *which)
{
    const struct waitfor_node *first = waits_by_itself(w);
    if (!first)
        return NULL;
    char text[120];
    snprintf(text, sizeof text, "Look at %s first (%s), which %s.", first->name,
             waitfor_cause_name(first->cause), which);
    return waitfor_text(w, text);
}

/* Does it wait for a message that a host program could send? */
static bool could_be_hosts(const struct waitfor_node *n)
{
    bool others = n->cause == WAITFOR_CYCLE || n->cause == WAITFOR_KNOT || n->cause == WAITFOR_ORPHAN;
    return others && n->what == WAITFOR_MESSAGE && !n->operation && n->select.node == WAITFOR_ANY;
}

static const char *remedy(const struct waitfor *w, const struct waitfor_node *n)
{
    static const char *const TEXTS[WAITFOR_CAUSES] = {
        [WAITFOR_WRONG_TYPE] = "Compare the type here with that in the sender's call.",
        [WAITFOR_WRONG_NODE] = "Compare the sender selected here with the one that has sent.",
        [WAITFOR_BUFFERS_FULL] =
            "Post receives (irecv) before the messages come, or let fewer come before they are received.",
        [WAITFOR_NODE_HAS_ENDED] =
            "See why it ended before that, or whether one message too many is awaited.",
        [WAITFOR_CYCLE] = "One of the cycle has to send before it receives, or to post its receive (irecv) "
                          "and go on.",
        [WAITFOR_KNOT] = "One of them has to send before it receives.",
        [WAITFOR_ORPHAN] = "Look for the send that has not been made.",
    };
    if (n->what == WAITFOR_BUFFER && n->to_held)
        return "Post one of the receives (MPI_Irecv) before the sends, or use MPI_Sendrecv.";
    const char *mpi =
        n->what == WAITFOR_MESSAGE && waitfor_is_mpi(n->select.pid) ? waitfor_mpi_remedy(n) : NULL;
    if (mpi)
        return mpi;
    if (is_alone(w, n))
        return "A host program loads the nodes (load) before it waits for them. Is this the host program? "
               "touchstone run --host HOST PROGRAM";
    if (n->cause == WAITFOR_TAKEN)
        return remedy_for_taken(n);
    if (n->cause == WAITFOR_MASKED)
        return n->masked ? "masktrap(0) before this call lets the handlers run."
                         : "Handlers do not run inside of handlers: wait outside.";
    if (n->cause == WAITFOR_CYCLE && n->operation && is_of_operations(w))
        return "All nodes have to call the global operations in the same order.";
    if (n->cause == WAITFOR_CYCLE && n->what == WAITFOR_END)
        return "One of the cycle has to end, or to send, without waiting for the others.";
    if (waitfor_lacks_host(w, n))
        return "Send from a node, or from a host program: touchstone run --host HOST PROGRAM";
    if (w->may_lack_host && could_be_hosts(n))
        return "A node has to send first, or a host program: touchstone run --host HOST PROGRAM";
    return TEXTS[n->cause];
}

/* May the cause be that another program ended too early? */
static bool may_be_of_exit(enum waitfor_cause c)
{
    return c == WAITFOR_NODE_HAS_ENDED || c == WAITFOR_KNOT || c == WAITFOR_ORPHAN;
}

void waitfor_find_reasons(struct waitfor *w)
{
    /* An orphan's message may be one that the node to look at would send next. */
    const char *exit = remedy_for_exit(w), *orphan = look_first(w, "may be to send it"),
               *collective = look_first(w, "does not wait in a collective");
    struct reasons r = {w, waitfor_choose(w, lives, NULL), waitfor_choose(w, has_ended, NULL), NULL, 0};
    for (uint32_t i = 0; i < w->count; i++) {
        struct waitfor_node *n = &w->nodes[i];
        if (n->state != WAITFOR_WAITS)
            continue;
        n->why = why(&r, n);
        if (exit && may_be_of_exit(n->cause))
            n->remedy = exit;
        else if (collective && waitfor_in_collective(n) && n->cause != WAITFOR_NODE_HAS_ENDED)
            n->remedy = collective;
        else
            n->remedy = orphan && n->cause == WAITFOR_ORPHAN ? orphan : remedy(w, n);
    }
    free(r.living.runs);
    free(r.ended.runs);
    free(r.missed);
}
