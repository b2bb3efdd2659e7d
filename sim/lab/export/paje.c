/* paje.c - a trace in Paje's format: Kergommeaux, Stein, Martin, "Paje input data format", 2003; as read by
 * Schnorr's pajeng.
 *
 * The machine is a container, and so is each node in it. A node has two rows of states: `State`, the parts of
 * its time, of which one follows the other; and `Call`, its calls and handlers, which nest. A message is a
 * link between nodes. */
#include "lab/export/paje.h"
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lab/export/decimal.h"
#include "lab/export/in_order.h"

static const char HEAD[] =
    "%EventDef PajeDefineContainerType 0\n% Alias string\n% Type string\n% Name string\n%EndEventDef\n"
    "%EventDef PajeDefineStateType 1\n% Alias string\n% Type string\n% Name string\n%EndEventDef\n"
    "%EventDef PajeDefineLinkType 2\n% Alias string\n% Type string\n% StartContainerType string\n"
    "% EndContainerType string\n% Name string\n%EndEventDef\n"
    "%EventDef PajeDefineEntityValue 3\n% Alias string\n% Type string\n% Name string\n% Color color\n"
    "%EndEventDef\n"
    "%EventDef PajeCreateContainer 4\n% Time date\n% Alias string\n% Type string\n% Container string\n"
    "% Name string\n%EndEventDef\n"
    "%EventDef PajeDestroyContainer 5\n% Time date\n% Type string\n% Name string\n%EndEventDef\n"
    "%EventDef PajeSetState 6\n% Time date\n% Container string\n% Type string\n% Value string\n%EndEventDef\n"
    "%EventDef PajePushState 7\n% Time date\n% Container string\n% Type string\n% Value string\n"
    "%EndEventDef\n"
    "%EventDef PajePopState 8\n% Time date\n% Container string\n% Type string\n%EndEventDef\n"
    "%EventDef PajeStartLink 9\n% Time date\n% Container string\n% Type string\n% StartContainer string\n"
    "% Value string\n% Key string\n% Size double\n%EndEventDef\n"
    "%EventDef PajeEndLink 10\n% Time date\n% Container string\n% Type string\n% EndContainer string\n"
    "% Value string\n% Key string\n%EndEventDef\n"
    "0 Machine 0 Machine\n"
    "0 Node Machine Node\n"
    "1 State Node State\n"
    "1 Call Node Call\n"
    "2 Message Machine Node Node Message\n";

enum { DEFINE_VALUE = 3, CREATE, DESTROY, SET_STATE, PUSH_STATE, POP_STATE, START_LINK, END_LINK };

struct writing {
    const struct timeline *l;
    struct in_order *lines;
    int32_t node;
};

/* Text between quotation marks: what of it would end them, or the line, becomes something else. */
static void put_text(FILE *out, const char *text)
{
    fputc('"', out);
    for (const char *c = text ? text : ""; *c; c++)
        fputc(*c == '"' ? '\'' : (unsigned char)*c < ' ' ? ' ' : *c, out);
    fputc('"', out);
}

static void define_values(const struct trace *t, FILE *out)
{
    static const char *const STATES[TRACE_STATES] = {[TRACE_COMPUTING] = "0.45 0.70 0.45",
                                                     [TRACE_IN_CALL] = "0.90 0.65 0.25",
                                                     [TRACE_WAITING] = "0.80 0.25 0.25",
                                                     [TRACE_IN_SYSTEM] = "0.55 0.40 0.70",
                                                     [TRACE_ENDED] = "0.90 0.90 0.90"};
    static const char *const CLASSES[] = {[TRACE_SENDS] = "0.25 0.45 0.80",
                                          [TRACE_RECEIVES] = "0.85 0.45 0.30",
                                          [TRACE_GLOBAL] = "0.60 0.35 0.65",
                                          [TRACE_FILES] = "0.45 0.55 0.30",
                                          [TRACE_OTHER] = "0.60 0.60 0.60"};
    for (int s = 0; s < TRACE_STATES; s++)
        fprintf(out, "%d s%d State \"%s\" \"%s\"\n", DEFINE_VALUE, s, trace_state_name(s), STATES[s]);
    for (int32_t i = 0; i < t->name_count; i++) {
        fprintf(out, "%d c%d Call ", DEFINE_VALUE, i);
        put_text(out, t->names[i]);
        fprintf(out, " \"%s\"\n", CLASSES[t->classes[i]]);
    }
    fprintf(out, "%d handler Call handler \"0.20 0.60 0.60\"\n", DEFINE_VALUE);
}

static void create_containers(const struct trace *t, FILE *out)
{
    fprintf(out, "%d %" PRI_SECONDS " m Machine 0 ", CREATE, SECONDS(t->from));
    put_text(out, t->machine);
    fputc('\n', out);
    for (int32_t i = 0; i < t->node_count; i++)
        fprintf(out, "%d %" PRI_SECONDS " n%d Node m \"%s\"\n", CREATE, SECONDS(t->from), i,
                t->nodes[i].name);
}

static void destroy_containers(const struct trace *t, FILE *out)
{
    for (int32_t i = 0; i < t->node_count; i++)
        fprintf(out, "%d %" PRI_SECONDS " Node n%d\n", DESTROY, SECONDS(t->to), i);
    fprintf(out, "%d %" PRI_SECONDS " Machine m\n", DESTROY, SECONDS(t->to));
}

/* --- a node --- */

static void enter(void *ctx, const struct timeline_slice *s)
{
    struct writing *w = ctx;
    if (s->kind == TIMELINE_CALL || s->kind == TIMELINE_LIBRARY)
        in_order_line(w->lines, s->begin, "%d %" PRI_SECONDS " n%d Call c%d\n", PUSH_STATE, SECONDS(s->begin),
                      w->node, w->l->trace->calls[s->index].name);
    else if (s->kind == TIMELINE_HANDLER)
        in_order_line(w->lines, s->begin, "%d %" PRI_SECONDS " n%d Call handler\n", PUSH_STATE,
                      SECONDS(s->begin), w->node);
}

static void leave(void *ctx, const struct timeline_slice *s)
{
    struct writing *w = ctx;
    if (s->kind == TIMELINE_CALL || s->kind == TIMELINE_LIBRARY || s->kind == TIMELINE_HANDLER)
        in_order_line(w->lines, s->end, "%d %" PRI_SECONDS " n%d Call\n", POP_STATE, SECONDS(s->end),
                      w->node);
}

static void message(void *ctx, const struct timeline_end *e)
{
    struct writing *w = ctx;
    const struct trace_message *m = &w->l->trace->messages[e->message];
    if (!timeline_has_ends(w->l, e->message))
        return;
    if (e->taken)
        in_order_line(w->lines, e->at, "%d %" PRI_SECONDS " m Message n%d \"type %d\" %d\n", END_LINK,
                      SECONDS(e->at), w->node, m->type, e->message);
    else
        in_order_line(w->lines, e->at, "%d %" PRI_SECONDS " m Message n%d \"type %d\" %d %" PRIu64 "\n",
                      START_LINK, SECONDS(e->at), w->node, m->type, e->message, m->bytes);
}

static void add_states(struct writing *w)
{
    struct trace_pieces pieces = {0};
    int last = -1;
    in_order_stream(w->lines);
    trace_pieces(w->l->trace, w->node, &pieces);
    for (size_t i = 0; i < pieces.count; i++) {
        const struct trace_piece *p = &pieces.list[i];
        if ((int)p->state != last && p->end > p->begin) {
            in_order_line(w->lines, p->begin, "%d %" PRI_SECONDS " n%d State s%d\n", SET_STATE,
                          SECONDS(p->begin), w->node, p->state);
            last = p->state;
        }
    }
    free(pieces.list);
}

bool paje_write(const struct timeline *l, FILE *out, const struct export_progress *p, char **error)
{
    static const struct timeline_visitor VISITOR = {enter, leave, message};
    struct writing w = {.l = l, .lines = in_order_new(error)};
    if (!w.lines)
        return false;
    for (w.node = 0; w.node < l->trace->node_count; w.node++) {
        if (!l->trace->nodes[w.node].traced)
            continue;
        add_states(&w);
        in_order_stream(w.lines);
        timeline_walk(l, w.node, &VISITOR, &w);
        export_progress_show(p, w.node);
    }
    fputs(HEAD, out);
    define_values(l->trace, out);
    create_containers(l->trace, out);
    bool ok = in_order_write(w.lines, out, error);
    destroy_containers(l->trace, out);
    in_order_free(w.lines);
    return ok;
}
