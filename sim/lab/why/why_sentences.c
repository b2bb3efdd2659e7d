/* why_sentences.c - see why_sentences.h. Each function writes one paragraph, or nothing. */
#include "lab/why/why_sentences.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "files/number.h"
#include "kernel/xalloc.h"
#include "lab/why/path_shares.h"

/* A part of the path, or of waits, is worth a word from one percent on. */
enum { WORTH = 100 };

static bool worth_a_word(vtime_sum part, vtime_sum whole)
{
    return part && part >= whole / WORTH;
}

/* The name with a capital letter. */
static struct why_text capital(const char *name)
{
    struct why_text x;
    snprintf(x.text, sizeof x.text, "%s", name);
    if (x.text[0] >= 'a' && x.text[0] <= 'z')
        x.text[0] = (char)(x.text[0] - 'a' + 'A');
    return x;
}

/* A node in a sentence: "node 3", "the host". */
static const char *node_words(const struct why *w, int32_t node)
{
    return strcmp(why_node_name(w, node), "host") ? why_node_name(w, node) : "the host";
}

/* --- what it is about --- */

/* "8 nodes of ipsc860 and its host": those that had a program. */
static void where(const struct trace *t, FILE *f)
{
    int32_t nodes = trace_nodes_ran(t);
    fprintf(f, "%" PRId32 " node%s of %s%s", nodes, nodes == 1 ? "" : "s", t->machine,
            t->topo.host ? " and its host" : "");
}

static int32_t untraced(const struct trace *t)
{
    int32_t count = 0;
    for (int32_t i = 0; i < t->node_count; i++)
        count += !t->nodes[i].traced;
    return count;
}

static void about(struct why *w, FILE *f)
{
    const struct trace *t = w->t;
    struct why_unit u = why_unit_for(t->end);
    fprintf(f, "%s took %s on ", basename(t->program), why_time(u, t->end).text);
    where(t, f);
    fputc('.', f);
    if (t->from || t->to < t->end)
        fprintf(f, " Only the part from %s to %s counts here.", why_time(u, t->from).text,
                why_time(u, t->to).text);
    if (!t->complete)
        fprintf(f, " The trace ends early: the run was killed.");
    int32_t stuck = 0;
    if (untraced(t))
        fprintf(f,
                " The trace has only %" PRId32 " of its %" PRId32 " nodes: what the others did is not known.",
                t->node_count - untraced(t), t->node_count);
    for (int32_t i = 0; i < t->call_count; i++)
        stuck += t->calls[i].unfinished;
    if (t->complete && stuck && t->to == t->end)
        fprintf(f, " %" PRId32 " node%s still in a call when it ended.", stuck,
                stuck == 1 ? " was" : "s were");
}

/* --- the critical path --- */

/* The path's steps that count: those of one node, or all. */
struct part {
    int32_t node; /* TRACE_NONE: all */
    vtime_sum time, of[WHY_CLASSES];
};

static struct part part_of(struct why *w, int32_t node)
{
    struct part p = {.node = node};
    for (int i = 0; i < WHY_CLASSES; i++)
        p.time += p.of[i] = why_part(w, node, (enum why_class)i);
    return p;
}

/* The functions of the program that have most of a class: ", mostly in a (2 s) and b (1 s)"; or if that is
 * less than half of it, ", among others in a (2 s) and b (1 s)". */
static void name_functions(struct why *w, const struct part *p, enum why_class class, const char *in, FILE *f)
{
    struct why_unit u = why_unit_for(w->length);
    struct tally functions = {0};
    for (size_t i = 0; i < w->path.count; i++) {
        const struct path_step *s = &w->path.steps[i];
        const char *name = why_function(w, s);
        if (s->class == class && (p->node == TRACE_NONE || s->node == p->node) && *name)
            tally_add(&functions, name, s->end - s->begin);
    }
    tally_sort(&functions);
    size_t named = functions.count < 2 ? functions.count : 2;
    if (named == 2 && functions.rows[1].time < p->of[class] / 10)
        named = 1;
    vtime sum = 0;
    for (size_t i = 0; i < named; i++)
        sum += functions.rows[i].time;
    for (size_t i = 0; i < named; i++)
        fprintf(f, "%s%s%s (%s)",
                i                         ? " and "
                : sum >= p->of[class] / 2 ? ", mostly "
                                          : ", among others ",
                i ? "" : in, functions.rows[i].label, why_time(u, functions.rows[i].time).text);
    tally_free(&functions);
}

/* How many handlers have a part of the path. */
static uint64_t handlers_on(const struct why *w, int32_t node)
{
    uint64_t count = 0;
    int32_t last = TRACE_NONE;
    for (size_t i = 0; i < w->path.count; i++) {
        const struct path_step *s = &w->path.steps[i];
        if (s->class != WHY_HANDLERS || (node != TRACE_NONE && s->node != node))
            continue;
        count += s->handler != last;
        last = s->handler;
    }
    return count;
}

/* How long the system entered and left handlers on the path. */
static vtime entering_on(const struct why *w, int32_t node)
{
    vtime sum = 0;
    for (size_t i = 0; i < w->path.count; i++) {
        const struct path_step *s = &w->path.steps[i];
        if (s->enters_handler && (node == TRACE_NONE || s->node == node))
            sum += s->end - s->begin;
    }
    return sum;
}

/* Says how long handlers took, behind " There," or nothing. */
static void say_handlers(struct why *w, const struct part *p, const char *before, FILE *f)
{
    struct why_unit u = why_unit_for(w->length);
    fprintf(f, "%s %s handlers took %s (%s)", before, number_grouped(handlers_on(w, p->node)).text,
            why_time(u, p->of[WHY_HANDLERS]).text, why_percent(p->of[WHY_HANDLERS], w->length).text);
    name_functions(w, p, WHY_HANDLERS, "for ", f);
    fprintf(f, "; entering and leaving them took %s of it.", why_time(u, entering_on(w, p->node)).text);
}

/* The sentence about a class; the first one about one node's part of the path says that the times are of that
 * part. */
static void say_class(struct why *w, const struct part *p, enum why_class class, bool first, FILE *f)
{
    static const char *const WORDS[WHY_CLASSES] = {
        [WHY_COMPUTING] = "the program computed",
        [WHY_CALLS] = "the system worked for the program's own calls",
        [WHY_OTHER_MESSAGES] = "the system handled messages that are not on the path",
        [WHY_MESSAGE] = "the system handled the path's own messages",
        [WHY_NETWORK] = "messages were on their way through the network",
        [WHY_CHANNEL] = "messages waited for channels that others held",
        [WHY_GRANT] = "long messages waited for late receivers",
        [WHY_FILES] = "calls waited for files",
        [WHY_WAITING] = "calls waited for a service, or for what the trace does not have",
        [WHY_ABSENT] = "no program was there",
    };
    bool there = first && p->node != TRACE_NONE;
    if (class == WHY_HANDLERS) {
        say_handlers(w, p, there ? " There," : "", f);
        return;
    }
    fprintf(f, " %s %s (%s) %s", there ? "There, for" : "For",
            why_time(why_unit_for(w->length), p->of[class]).text, why_percent(p->of[class], w->length).text,
            WORDS[class]);
    if (class == WHY_COMPUTING)
        name_functions(w, p, class, "in ", f);
    fputc('.', f);
}

/* The classes of the part that are worth a word, the longest first. */
static void say_classes(struct why *w, const struct part *p, FILE *f)
{
    bool said[WHY_CLASSES] = {false};
    for (int n = 0; n < WHY_CLASSES; n++) {
        int most = tally_longest(p->of, WHY_CLASSES, said);
        if (most < 0 || !worth_a_word(p->of[most], p->time))
            break;
        say_class(w, p, (enum why_class)most, n == 0, f);
    }
}

/* The time of the nodes' programs, but for one node. */
static vtime_sum time_of_others(const struct why *w, int32_t but, vtime_sum *idle)
{
    vtime_sum all = 0;
    *idle = 0;
    for (int32_t i = 0; i < w->t->node_count; i++) {
        vtime end = vt_min(w->t->nodes[i].end, w->t->to);
        if (i != but && w->t->nodes[i].traced && end > w->t->from)
            all += end - w->t->from;
    }
    for (size_t i = 0; i < w->causes.count; i++)
        *idle += w->causes.parts[i].node != but ? w->causes.parts[i].idle : 0;
    return all;
}

/* Do all nodes work for nearly all of the run? Less work on one of them would change little. Of some nodes'
 * waits nobody can say, nor of nodes that are not traced. */
static bool all_work(const struct why *w)
{
    vtime_sum idle, all = time_of_others(w, TRACE_NONE, &idle), run = 0;
    for (int32_t i = 0; i < w->t->node_count; i++)
        run += w->t->nodes[i].traced ? w->length : 0;
    return w->t->node_count > 1 && !w->some_nodes && !untraced(w->t) && run - (all - idle) < run / 20;
}

/* Does one node have more than three quarters of the path, and others time to spare? */
static bool one_decides(struct why *w, int32_t *node, vtime *part)
{
    *node = why_main_node(w, part);
    return *part > w->length / 4 * 3 && w->t->node_count > 1 && !all_work(w) && !untraced(w->t);
}

static void path(struct why *w, FILE *f)
{
    int32_t node;
    vtime time;
    struct why_unit u = why_unit_for(w->length);
    bool one = one_decides(w, &node, &time);
    struct part p = part_of(w, one ? node : TRACE_NONE);
    if (one) {
        fprintf(
            f,
            "%s decides how long the run takes. The critical path, traced from the end of the run back to "
            "its start along what had to happen first, is on %s for %s, %s of it.",
            capital(node_words(w, node)).text, node_words(w, node), why_time(u, time).text,
            why_percent(time, w->length).text);
    } else if (w->t->node_count > 1) {
        fprintf(f,
                "%sThe critical path, traced from the end of the run back to its start along what had to "
                "happen first, ",
                all_work(w) ? "All nodes work for nearly all of the run: none of them alone decides how long "
                              "it takes. "
                            : "");
        if (w->path.jumps)
            fprintf(f, "goes %s time%s from one node to another; its largest part, %s, is on %s.",
                    number_grouped(w->path.jumps).text, w->path.jumps == 1 ? "" : "s",
                    why_percent(time, w->length).text, node_words(w, node));
        else
            fprintf(f, "is on %s alone.", node_words(w, node));
    }
    say_classes(w, &p, f);
}

/* --- the cause --- */

/* What stands in the way of computing: the class, or the two that belong together, with the most of the
 * path. */
static void cause(struct why *w, FILE *f)
{
    int32_t node;
    vtime time;
    bool one = one_decides(w, &node, &time);
    struct why_unit u = why_unit_for(w->length);
    struct part p = part_of(w, one ? node : TRACE_NONE);
    vtime_sum served = p.of[WHY_HANDLERS] + p.of[WHY_OTHER_MESSAGES];
    int most = WHY_CALLS;
    for (int i = WHY_CALLS; i < WHY_CLASSES; i++)
        most = p.of[i] > p.of[most] ? i : most;
    if (p.time - p.of[WHY_COMPUTING] < p.time / 20) {
        fprintf(f,
                "So computing is the only cause: only less of it on %s, or a faster processor, makes the run "
                "shorter.",
                all_work(w) ? "all nodes"
                : one       ? node_words(w, node)
                            : "the path");
    } else if (one && (most == WHY_HANDLERS || most == WHY_OTHER_MESSAGES)) {
        fprintf(
            f,
            "So serving the others keeps %s from its own work: their messages take %s, %s of the run, the "
            "larger part of it in %s.",
            node_words(w, node), why_time(u, served).text, why_percent(served, w->length).text,
            p.of[WHY_HANDLERS] >= p.of[WHY_OTHER_MESSAGES] ? "handlers" : "interrupts of its system");
    } else {
        vtime_sum whole = part_of(w, TRACE_NONE).of[most];
        fprintf(f, "Besides computing, the largest cause is %s: %s of the path.",
                why_class_subject((enum why_class)most), why_percent(whole, w->length).text);
    }
}

/* --- waiting --- */

/* The node for which others waited longest, but for the waits of one node. */
static int32_t awaited(const struct why *w, int32_t but, vtime_sum *time)
{
    vtime_sum *of = xcalloc((size_t)w->t->node_count, sizeof *of);
    int32_t most = 0;
    for (size_t i = 0; i < w->causes.count; i++)
        if (w->causes.parts[i].partner != TRACE_NONE && w->causes.parts[i].node != but)
            of[w->causes.parts[i].partner] += w->causes.parts[i].idle;
    for (int32_t i = 1; i < w->t->node_count; i++)
        most = of[i] > of[most] ? i : most;
    *time = of[most];
    free(of);
    return most;
}

static const char *cause_words(enum wait_cause cause, enum trace_state doing)
{
    static const char *const WORDS[WAIT_CAUSES] = {
        [WAIT_LATE_SENDER] = "the sender was not there yet",
        [WAIT_LATE_RECEIVER] = "the receiver of a long message was late",
        [WAIT_HANDLER] = "the partner was in a handler",
        [WAIT_OTHER_MESSAGES] = "a processor was busy with other messages",
        [WAIT_CHANNEL] = "another message held a channel",
        [WAIT_NETWORK] = "the message was on its way",
        [WAIT_MESSAGE] = "the partner's system handled the message",
        [WAIT_DISK] = "the file system was not done",
        [WAIT_NEVER] = "nothing came until the end",
        [WAIT_UNKNOWN] = "a service was not done, or the trace does not have it",
    };
    if (cause == WAIT_LATE_SENDER && doing == TRACE_COMPUTING)
        return "the sender still computed";
    if (cause == WAIT_LATE_SENDER && doing == TRACE_IN_CALL)
        return "the sender was in a call";
    if (cause == WAIT_LATE_SENDER && doing == TRACE_WAITING)
        return "the sender waited, too (the critical path shows for what)";
    return WORDS[cause];
}

struct reason {
    enum wait_cause cause;
    enum trace_state doing;
    vtime_sum idle;
};

static int by_idle(const void *a, const void *b)
{
    const struct reason *x = a, *y = b;
    if (x->idle != y->idle)
        return x->idle > y->idle ? -1 : 1;
    return x->cause != y->cause ? (int)x->cause - (int)y->cause : (int)x->doing - (int)y->doing;
}

/* Why nodes, but for one, waited for the partner (TRACE_NONE: for anybody), the longest first; in shares of
 * all their waiting. */
static void say_reasons(const struct why *w, int32_t but, int32_t partner, vtime_sum all, FILE *f)
{
    struct reason reasons[WAIT_CAUSES * TRACE_STATES];
    for (int i = 0; i < WAIT_CAUSES * TRACE_STATES; i++)
        reasons[i] =
            (struct reason){(enum wait_cause)(i / TRACE_STATES), (enum trace_state)(i % TRACE_STATES), 0};
    for (size_t i = 0; i < w->causes.count; i++) {
        const struct wait_part *p = &w->causes.parts[i];
        if (p->node != but && (partner == TRACE_NONE || p->partner == partner))
            reasons[(int)p->cause * TRACE_STATES + (int)p->doing].idle += p->idle;
    }
    qsort(reasons, WAIT_CAUSES * TRACE_STATES, sizeof *reasons, by_idle);
    for (int i = 0; i < 4 && worth_a_word(reasons[i].idle, all); i++)
        fprintf(f, "%s%s because %s", i ? ", " : "", why_percent(reasons[i].idle, all).text,
                cause_words(reasons[i].cause, reasons[i].doing));
}

static void waiting(struct why *w, FILE *f)
{
    vtime part;
    vtime_sum for_one, idle;
    int32_t node;
    if (w->some_nodes)
        return; /* the tables are about some nodes, the sentences about all */
    bool one = one_decides(w, &node, &part);
    int32_t but = one ? node : TRACE_NONE, partner = awaited(w, but, &for_one);
    vtime_sum all = time_of_others(w, but, &idle);
    if (!w->causes.idle) {
        fputs("No node waited.", f);
        return;
    }
    if (!worth_a_word(idle, all)) {
        fprintf(f, "The %snodes hardly waited: %s of their time.", one ? "other " : "",
                why_percent(idle, all).text);
        return;
    }
    fprintf(f, "The %snodes waited for %s of their time, %s in all", one ? "other " : "",
            why_percent(idle, all).text, why_time(why_unit_for(idle), idle).text);
    bool mainly = for_one > idle / 2 && w->t->node_count > 2;
    if (mainly)
        fprintf(f, ". Of all waiting, %s was for %s: ", why_percent(for_one, idle).text,
                node_words(w, partner));
    else
        fputs(": ", f);
    say_reasons(w, but, mainly ? partner : TRACE_NONE, idle, f);
    fputc('.', f);
}

/* --- what if --- */

static void what_if(struct why *w, FILE *f)
{
    struct why_unit u = why_unit_for(w->length);
    bool said[WHY_CLASSES] = {[WHY_ABSENT] = true, [WHY_WAITING] = true};
    for (int n = 0; n < 3; n++) {
        int most = tally_longest(w->by_class, WHY_CLASSES, said);
        if (most < 0 || !worth_a_word(w->by_class[most], w->length))
            return;
        vtime_sum left = w->length - w->by_class[most];
        if (!left)
            return; /* the sentence about causes says that there is no other */
        fprintf(f, "%s%s took no time, the run would take at least %s, and be at most %s times faster.",
                n ? " If " : "If ", why_class_subject((enum why_class)most), why_time(u, left).text,
                why_faster(w->length, left).text);
    }
}

/* --- all of them --- */

char **why_sentences(struct why *w)
{
    static void (*const PARAGRAPHS[])(struct why *, FILE *) = {about, path, cause, waiting, what_if};
    enum { COUNT = sizeof PARAGRAPHS / sizeof *PARAGRAPHS };
    char **paragraphs = xcalloc(COUNT + 1, sizeof *paragraphs);
    int used = 0;
    for (int i = 0; i < COUNT; i++) {
        size_t size;
        FILE *f = xchecked(open_memstream(&paragraphs[used], &size));
        PARAGRAPHS[i](w, f);
        fclose(f);
        if (size)
            used++;
        else
            free(paragraphs[used]), paragraphs[used] = NULL;
    }
    return paragraphs;
}

void why_sentences_free(char **paragraphs)
{
    for (char **p = paragraphs; p && *p; p++)
        free(*p);
    free(paragraphs);
}
