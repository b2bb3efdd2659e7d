/* path_shares.c - see path_shares.h. */
#include "lab/why/path_shares.h"
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "nx_api/waitfor/waitfor_mpi.h"

static const struct {
    const char *key, *title;
} SHARES[WHY_SHARES] = {
    [WHY_BY_NODE] = {"by_node", "node"},
    [WHY_BY_FUNCTION] = {"by_function", "function"},
    [WHY_BY_CALL] = {"by_call", "call"},
    [WHY_BY_MESSAGE] = {"by_message", "message"},
};

const char *why_share_key(enum why_share s)
{
    return SHARES[s].key;
}

const char *why_share_title(enum why_share s)
{
    return SHARES[s].title;
}

/* The message that a step is about; TRACE_NONE. */
static int32_t message_of(const struct trace *t, const struct path_step *s)
{
    if (s->message != TRACE_NONE || s->call == TRACE_NONE)
        return s->message;
    const struct trace_call *c = &t->calls[s->call];
    return c->sent != TRACE_NONE ? c->sent : c->taken;
}

/* Has the step a call before or behind it? No call follows at a program's end. */
static bool is_beside_call(const struct path_step *s)
{
    return s->stack != TRACE_NONE || s->before != TRACE_NONE;
}

const char *why_function(struct why *w, const struct path_step *s)
{
    bool computes = is_beside_call(s) && s->call == TRACE_NONE && !s->enters_handler;
    return computes ? places_worker(w->places, s->before, s->seen, s->stack)
                    : places_function(w->places, s->stack);
}

/* The program's function that has the step: of steps in which the program works. */
static const char *function_of(struct why *w, const struct path_step *s)
{
    bool program = s->class == WHY_COMPUTING || s->class == WHY_CALLS || s->class == WHY_HANDLERS ||
                   s->class == WHY_FILES;
    const char *name = program ? why_function(w, s) : "";
    if (!program)
        return "(not in the program)";
    if (!is_beside_call(s))
        return "main or others"; /* a program without a call of NX's: no stack says more */
    return *name ? name : "(not known)";
}

/* The call whose time the step is; NULL: of none. */
static const char *call_of(struct why *w, const struct path_step *s)
{
    bool is_call =
        s->class == WHY_CALLS || s->class == WHY_FILES || s->class == WHY_WAITING || s->class == WHY_HANDLERS;
    return is_call && s->call != TRACE_NONE ? places_call(w->places, s->call) : NULL;
}

/* "type 5", "tag 5 in MPI_COMM_WORLD", "collective 2 in communicator 3" */
static const char *label_of(const struct why *w, const struct trace_message *m)
{
    char *in = trace_communicator(m->pid);
    const char *text = in ? places_text(w->places, "%s %d in %s", waitfor_mpi_type(m->pid), m->type, in)
                          : places_text(w->places, "type %d", m->type);
    free(in);
    return text;
}

static void share(struct why *w, const struct path_step *s)
{
    vtime time = s->end - s->begin;
    int32_t message = message_of(w->t, s);
    const char *call = call_of(w, s);
    w->by_class[s->class] += time;
    w->entering += s->enters_handler ? time : 0;
    tally_add(&w->shares[WHY_BY_NODE], why_node_name(w, s->node), time);
    tally_add(&w->shares[WHY_BY_FUNCTION], function_of(w, s), time);
    if (call)
        tally_add(&w->shares[WHY_BY_CALL], call, time);
    if (message != TRACE_NONE)
        tally_add(&w->shares[WHY_BY_MESSAGE], label_of(w, &w->t->messages[message]), time);
}

void path_shares_find(struct why *w)
{
    for (size_t i = 0; i < w->path.count; i++)
        share(w, &w->path.steps[i]);
    for (int i = 0; i < WHY_SHARES; i++)
        tally_sort(&w->shares[i]);
}

vtime why_part(const struct why *w, int32_t node, enum why_class class)
{
    vtime sum = 0;
    for (size_t i = 0; i < w->path.count; i++) {
        const struct path_step *s = &w->path.steps[i];
        if (s->class == class && (node == TRACE_NONE || s->node == node))
            sum += s->end - s->begin;
    }
    return sum;
}

int32_t why_main_node(const struct why *w, vtime *part)
{
    vtime *of = xcalloc((size_t)w->t->node_count, sizeof *of);
    int32_t most = 0;
    for (size_t i = 0; i < w->path.count; i++)
        if (w->path.steps[i].node != TRACE_NONE)
            of[w->path.steps[i].node] += w->path.steps[i].end - w->path.steps[i].begin;
    for (int32_t i = 1; i < w->t->node_count; i++)
        most = of[i] > of[most] ? i : most;
    *part = of[most];
    free(of);
    return most;
}
