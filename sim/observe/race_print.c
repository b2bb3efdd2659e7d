/* race_print.c - see race_print.h. */
#include "observe/race_print.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "files/ink.h"
#include "files/virtual_time.h"
#include "kernel/xalloc.h"

enum { MOST_OTHERS = 8 }; /* pairs of places in a report beside the first */

/* --- pieces; all are malloc'd --- */

/* "queue.c:12", or the function if the program was built without -g. */
static char *line_of(const struct race_frame *f)
{
    if (*f->file)
        return xasprintf("%s:%d", f->file, f->line);
    return xstrdup(*f->function ? f->function : "an unknown line");
}

static char *frame_text(const struct race_frame *f)
{
    char *line = line_of(f);
    char *text = *f->function && *f->file ? xasprintf("%s (%s)", f->function, line) : xstrdup(line);
    free(line);
    return text;
}

static const char *verb(const struct race_report_side *s)
{
    return s->reads && s->writes ? "reads and writes" : s->writes ? "writes" : "reads";
}

static const char *strand(const struct race_report_side *s)
{
    return s->in_handler ? "handler" : "main program";
}

/* "on_done writes", "main program's crecv writes" */
static char *access_text(const struct race_report_side *s)
{
    return s->call ? xasprintf("%s's %s %s", strand(s), s->call, verb(s))
                   : xasprintf("%s %s", strand(s), verb(s));
}

char *race_print_head(const struct race_report *r)
{
    const struct race_report_side *a = &r->side[0], *b = &r->side[1];
    char *at = line_of(&a->frames[0]), *other = line_of(&b->frames[0]), *does = access_text(a), *text;
    const char *variable = *r->variable ? r->variable : "memory";
    if (r->what == RACE_OF_BUFFERS)
        text = xasprintf("race on %s: %s at %s is given a buffer that is under way for %s at %s", variable,
                         b->call, other, a->call, at);
    else if (race_report_is_of_buffer(r))
        text = xasprintf("race on %s: %s %s at %s the buffer of %s at %s", variable, strand(b), verb(b),
                         other, a->call, at);
    else {
        char *others = access_text(b);
        text = xasprintf("race on %s: %s at %s, %s at %s", variable, does, at, others, other);
        free(others);
    }
    free(at);
    free(other);
    free(does);
    return text;
}

/* --- why --- */

static char *why_buffer(const struct race_report *r)
{
    const struct race_report_side *a = &r->side[0];
    bool blocks = strncmp(a->call + (*a->call == '_'), "c", 1) == 0;
    const char *until = strncmp(a->call, "MPI_", 4) == 0
                            ? "MPI_Wait, or a call like it, has completed its request"
                        : blocks               ? "that call has returned"
                        : strchr(a->call, 'h') ? "its handler runs"
                                               : "msgwait returns, or msgdone returns 1";
    if (r->what == RACE_ON_SEND)
        return xasprintf(
            "the bytes may leave at any time until %s; what is written before may be sent, or not", until);
    if (r->what == RACE_ON_RECEIVE)
        return xasprintf("a message may be put there at any time until %s", until);
    return xasprintf("both move bytes there, in any order; the first is under way until %s", until);
}

static char *why_posted(const struct race_report *r)
{
    char *posted = line_of(&r->side[0].posted);
    const char *call = r->side[0].posted_by ? r->side[0].posted_by : "hrecv";
    char *text =
        xasprintf("%s at %s has posted the handler, which may run at any time from then on", call, posted);
    free(posted);
    return text;
}

static char *why_accesses(const struct race_report *r)
{
    char *posted = why_posted(r), *line = line_of(&r->side[1].frames[0]), *text;
    if (r->what == RACE_OF_UPDATE)
        text = xasprintf("%s, also between the main program's reading and its writing at %s, which has no "
                         "masktrap(1) around it: then what the handler has written is lost",
                         posted, line);
    else
        text = xasprintf(
            "%s; no masktrap(1) keeps handlers from running at %s; and neither of the two waits for "
            "a message or a volatile variable that would put them in order",
            posted, line);
    free(posted);
    free(line);
    return text;
}

char *race_print_why(const struct race_report *r)
{
    return race_report_is_of_buffer(r) ? why_buffer(r) : why_accesses(r);
}

/* --- where --- */

static void add_range(FILE *f, size_t first, size_t last)
{
    fprintf(f, "%s%zu", ftell(f) ? ", " : "", first);
    if (last > first)
        fprintf(f, "-%zu", last);
}

char *race_print_nodes(const struct race_report *r)
{
    char *text = NULL;
    size_t size;
    FILE *f = xchecked(open_memstream(&text, &size));
    for (size_t i = 1, end; i < r->nodes; i = end) {
        for (end = i; end < r->nodes && r->on_node[end]; end++)
            ;
        if (end > i)
            add_range(f, i - 1, end - 2);
        else
            end = i + 1;
    }
    if (r->nodes && r->on_node[0])
        fprintf(f, "%shost", ftell(f) ? ", " : "");
    fclose(f);
    return text;
}

static void print_time(const struct race_report_side *s, FILE *f)
{
    if (s->at == VT_NEVER)
        fputs(", long before", f);
    else
        fprintf(f, ", %s %s",
                s->call         ? "at"
                : s->in_handler ? "in the run at"
                                : "after",
                virtual_time_moment(s->at).text);
}

/* A stack: the access with its time, then who has called. */
static void print_side(const struct race_report_side *s, FILE *f)
{
    for (size_t i = 0; i < s->depth; i++) {
        char *frame = frame_text(&s->frames[i]);
        if (i == 0)
            fprintf(f, "  %-13s %s%s%s", strand(s), s->call ? s->call : "", s->call ? " in " : "", frame);
        else
            fprintf(f, "  %-13s called from %s", "", frame);
        if (i == 0)
            print_time(s, f);
        fputc('\n', f);
        free(frame);
    }
    if (!s->posted_by)
        return;
    char *posted = frame_text(&s->posted);
    fprintf(f, "  %-13s posted by %s in %s\n", "", s->posted_by, posted);
    free(posted);
}

/* 1204567 as 1,204,567 */
static void print_number(uint64_t n, FILE *f)
{
    if (n >= 1000) {
        print_number(n / 1000, f);
        fprintf(f, ",%03" PRIu64, n % 1000);
    } else {
        fprintf(f, "%" PRIu64, n);
    }
}

/* "6 times on nodes 0-3" */
static void print_found(const struct race_report *r, FILE *f)
{
    char *nodes = race_print_nodes(r);
    const char *what = strcmp(nodes, "host") == 0 ? "the " : strpbrk(nodes, ",-") ? "nodes " : "node ";
    print_number(r->count, f);
    fprintf(f, " %s on %s%s", r->count == 1 ? "time" : "times", what, nodes);
    free(nodes);
}

static void print_where(const struct race_report *r, FILE *f)
{
    fprintf(f, "  %-13s ", "found");
    print_found(r, f);
    fprintf(f, "; the above on %s, where the %s came %s\n", r->node,
            race_report_is_of_buffer(r) ? "call" : "handler", r->first_came_later ? "later" : "first");
}

/* "race on VARIABLE: ...": what comes before the colon stands out. */
static void print_head(const char *head, const struct ink *ink, FILE *f)
{
    int length = (int)strcspn(head, ":");
    fprintf(f, "%s%.*s%s%s\n", ink->yellow, length, head, ink->off, head + length);
}

/* The other places at which the variable of race i races, a line each. */
static void print_others(const struct race_reports *t, size_t i, FILE *f)
{
    size_t told = 0, left = 0;
    for (size_t k = i + 1; k < t->count; k++) {
        if (t->list[k].group != i)
            continue;
        if (told == MOST_OTHERS) {
            left++;
            continue;
        }
        char *head = race_print_head(&t->list[k]);
        fprintf(f, "  %-13s %s, ", told++ ? "" : "also", head + strcspn(head, ":") + 2);
        print_found(&t->list[k], f);
        fputc('\n', f);
        free(head);
    }
    if (left)
        fprintf(f, "  %-13s and at %zu more pairs of places, which --races FILE writes\n", "", left);
}

static void print(const struct race_report *r, const struct ink *ink, FILE *f)
{
    char *head = race_print_head(r), *why = race_print_why(r);
    print_head(head, ink, f);
    print_side(&r->side[0], f);
    print_side(&r->side[1], f);
    fprintf(f, "  %-13s %s.\n", "why", why);
    print_where(r, f);
    free(head);
    free(why);
}

void race_print(const struct race_reports *t, FILE *f)
{
    struct ink ink = ink_for(f);
    for (size_t i = 0; i < t->count; i++) {
        if (t->list[i].group != i)
            continue;
        print(&t->list[i], &ink, f);
        print_others(t, i, f);
    }
}

void race_print_count(const struct race_reports *t, FILE *f)
{
    if (!t->checked)
        return;
    fprintf(f, "races          %zu found", t->count);
    if (t->groups < t->count)
        fprintf(f, ", in %zu report%s", t->groups, t->groups == 1 ? "" : "s");
    if (t->suppressed)
        fprintf(f, ", %zu suppressed", t->suppressed);
    if (t->dropped)
        fprintf(f, "; %" PRIu64 " more accesses in places for which there was no room", t->dropped);
    fputc('\n', f);
}
