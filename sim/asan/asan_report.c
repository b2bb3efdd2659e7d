/* asan_report.c - what a checked program has done wrong, in words: see node_asan.h. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "asan/node_asan.h"
#include "guest/backtrace.h"
#include "guest/image.h"
#include "kernel/xalloc.h"
#include "node/self.h"
#include "node/system.h"
#include "nx_api/contract/program_image.h"
#include "nx_api/contract/races.h"
#include "os/fail.h"

/* What an access has missed. */
struct object {
    uintptr_t begin;
    size_t bytes; /* SIZE_MAX: no object is known */
    const char *name, *file;
    int line;
};

/* --- stacks --- */

static bool print_call(FILE *f, const struct node *n, const char *how, uintptr_t address)
{
    char line[200];
    size_t offset = address - (uintptr_t)n->guest.program;
    const char *name = node_image_function_name(n->guest.file, offset);
    fprintf(f, "\n    %s %s", how, name ? name : "the program");
    if (node_image_line(n->guest.file, offset, line, sizeof line))
        fprintf(f, " (%s)", line);
    return true;
}

bool asan_is_of_nxcc(const struct node *n, size_t returns)
{
    const char *name = node_image_function_name(n->guest.file, returns - 1);
    return name && strncmp(name, "nxc_", 4) == 0;
}

/* Prints the calls of a stack from `first` on that are the program's own, not of the libraries or of nxcc. */
static void print_calls(FILE *f, const struct node *n, const char *how, const struct asan_stack *s,
                        uint32_t first)
{
    uintptr_t own[ASAN_DEEPEST];
    int count = 0;
    for (uint32_t i = first; i < s->depth; i++)
        if (!asan_is_of_nxcc(n, s->returns[i]) && !node_image_in_library(n->guest.file, s->returns[i] - 1))
            own[count++] = (uintptr_t)n->guest.program + s->returns[i] - 1;
    backtrace_print_as(print_call, f, n, how, own, count);
}

static void print_stack(FILE *f, const struct node *n, const struct asan_stack *s)
{
    if (s)
        print_calls(f, n, "in", s, 0);
}

/* The site's own function is on the stack behind what nxcc adds to programs; GCC may have inlined it. */
static void print_site(FILE *f, const struct node *n, const struct nxc_race_site *site,
                       const struct asan_stack *s)
{
    uint32_t i = 0;
    fprintf(f, "\n    in %s (%s:%d)", nxc_race_text(site, site->function),
            basename(nxc_race_text(site, site->file)), site->line);
    while (i < s->depth && asan_is_of_nxcc(n, s->returns[i]))
        i++;
    print_calls(f, n, "called from", s, i + 1);
}

static void print_access(FILE *f, struct node *n, const struct asan_access *a)
{
    static const struct asan_stack none;
    const struct asan_stack *s =
        asan_stacks_at(n->asan->stacks, asan_stacks_here(n->asan->stacks, n, a->frame));
    if (a->site)
        print_site(f, n, a->site, s ? s : &none);
    else
        print_stack(f, n, s);
}

/* --- what was missed --- */

static struct object of_block(const struct node *n, uintptr_t at)
{
    const struct asan_block *b = asan_block_near(n, at);
    return b ? (struct object){.begin = asan_block_begin(b), .bytes = b->bytes}
             : (struct object){.bytes = SIZE_MAX};
}

/* The variable of a file that begins last before an address; of one, the largest. */
static struct object of_global(const struct node *n, uintptr_t at)
{
    const struct nxc_asan *image = n->guest.image->races->asan;
    struct object o = {.bytes = SIZE_MAX};
    for (const struct nxc_asan_global *g = image->globals_begin; g < image->globals_end; g++) {
        uintptr_t begin = (uintptr_t)&g->at + (uintptr_t)g->at;
        if (begin <= at && (begin > o.begin || (begin == o.begin && g->bytes > o.bytes)))
            o = (struct object){begin, g->bytes, (const char *)g + g->name, (const char *)g + g->file,
                                g->line};
    }
    return o;
}

/* The red zone that an address lies in tells the variable before it. What it holds may have been written over
 * by what went wrong. */
static struct object of_local(const struct node *n, uintptr_t at)
{
    const struct asan_shadow *s = &n->asan->shadow;
    uintptr_t zone = at / NXC_ASAN_GRAIN * NXC_ASAN_GRAIN;
    if (asan_shadow_why(s, zone) != NXC_ASAN_LOCAL)
        return (struct object){.bytes = SIZE_MAX};
    while (zone + NXC_ASAN_ZONE > at && s->of[(zone - s->low) / NXC_ASAN_GRAIN] != NXC_ASAN_LOCAL)
        zone += NXC_ASAN_GRAIN; /* the variable's last grain */
    while (s->of[(zone - NXC_ASAN_GRAIN - s->low) / NXC_ASAN_GRAIN] == NXC_ASAN_LOCAL)
        zone -= NXC_ASAN_GRAIN;
    const struct nxc_asan_local *l = (const struct nxc_asan_local *)(zone + NXC_ASAN_LOCAL_AT);
    const struct nxc_races *sites = n->guest.image->races;
    if (l->site < sites->sites_begin || l->site >= sites->sites_end || !(l->site->flags & NXC_RACE_LOCAL))
        return (struct object){.bytes = SIZE_MAX};
    return (struct object){zone - nxc_asan_zone_at(l->bytes), l->bytes,
                           nxc_race_text(l->site, l->site->variable), nxc_race_text(l->site, l->site->file),
                           l->site->line};
}

static struct object object_of(const struct node *n, uintptr_t at, uint8_t why)
{
    return why == NXC_ASAN_LOCAL                                ? of_local(n, at)
           : why == NXC_ASAN_GLOBAL                             ? of_global(n, at)
           : why == NXC_ASAN_RETURNED || why == NXC_ASAN_OTHERS ? (struct object){.bytes = SIZE_MAX}
                                                                : of_block(n, at);
}

/* --- text --- */

static const char *kind_of(uint8_t why)
{
    switch (why) {
    case NXC_ASAN_LOCAL:
        return "stack-buffer-overflow";
    case NXC_ASAN_RETURNED:
        return "stack-use-after-return";
    case NXC_ASAN_GLOBAL:
        return "global-buffer-overflow";
    case NXC_ASAN_FREED:
        return "heap-use-after-free";
    case NXC_ASAN_OTHERS:
        return "memory-of-another-node";
    default:
        return "heap-buffer-overflow";
    }
}

struct bytes_text {
    char text[32];
};

static struct bytes_text bytes_text(size_t bytes)
{
    struct bytes_text t;
    snprintf(t.text, sizeof t.text, "%zu byte%s", bytes, bytes == 1 ? "" : "s");
    return t;
}

static void print_object_name(FILE *f, const struct object *o)
{
    if (o->name)
        fprintf(f, "%s (%s, %s:%d)", o->name, bytes_text(o->bytes).text, basename(o->file), o->line);
    else
        fprintf(f, "a block of %s", bytes_text(o->bytes).text);
}

/* Where the first bad byte is. */
static void print_position(FILE *f, const struct node *n, const struct asan_access *a, uint8_t why,
                           const struct object *o)
{
    uintptr_t end = o->begin + o->bytes;
    if (why == NXC_ASAN_OTHERS) {
        const struct node *owner = node_owner(n->sys, a->bad);
        fprintf(f, "at 0x%zx, which %s%s", (size_t)a->bad, owner ? "belongs to " : "no node has now",
                owner ? owner->cold->name : "");
        return;
    }
    if (why == NXC_ASAN_RETURNED) {
        fputs("where a function that has returned had its variables", f);
        return;
    }
    if (o->bytes == SIZE_MAX) {
        fprintf(f, "at 0x%zx, where the program has nothing", (size_t)a->bad);
        return;
    }
    if (a->bad >= o->begin && a->bad < end) {
        fprintf(f, "%s into ", bytes_text(a->bad - o->begin).text);
    } else {
        size_t away = a->bad < o->begin ? o->begin - a->bad : a->bad - end;
        const char *side = a->bad < o->begin ? "before" : "behind";
        if (a->bad > a->at)
            fprintf(f, "the last %zu of them ", a->bytes - (size_t)(a->bad - a->at));
        if (away)
            fprintf(f, "%s %s ", bytes_text(away).text, side);
        else
            fprintf(f, "just %s ", side);
    }
    print_object_name(f, o);
}

static void print_block(FILE *f, const struct node *n, const struct asan_block *b)
{
    if (!b)
        return;
    if (!b->counted) {
        fprintf(f, "\n  it was freed");
        print_stack(f, n, asan_stacks_at(n->asan->stacks, b->freed));
    }
    fprintf(f, "\n  it was allocated");
    print_stack(f, n, asan_stacks_at(n->asan->stacks, b->allocated));
}

/* Has an earlier call told NX of the buffer? */
static bool is_posted(const struct asan_access *a)
{
    return !a->call || strncmp(a->call, "msg", 3) == 0;
}

/* Whose buffer NX has written to, or read. */
static const char *buffer_of(const struct asan_access *a)
{
    return !is_posted(a) ? a->call : a->call ? "irecv" : "hrecv";
}

static void print_advice(FILE *f, const struct asan_access *a, uint8_t why, const struct object *o)
{
    fputs("\n  to do: ", f);
    if (why == NXC_ASAN_FREED)
        fputs("free the block after its last use, or let no pointer to it live on", f);
    else if (why == NXC_ASAN_RETURNED)
        fputs("let no pointer to a function's variables live on after its return", f);
    else if (why == NXC_ASAN_OTHERS)
        fputs("send what a pointer points to: on another node an address means nothing", f);
    else if (!a->site)
        fprintf(f, "give %s a buffer of at least %s%s, or a smaller length", buffer_of(a),
                bytes_text(a->bytes).text,
                why == NXC_ASAN_LOCAL && is_posted(a) ? " that is there until the message comes" : "");
    else if (o->name)
        fprintf(f, "make %s larger, or keep within it", o->name);
    else
        fputs("ask for more bytes, or keep within the block", f);
}

/* What the source calls what is accessed; or the call. */
static void print_accessor(FILE *f, const struct asan_access *a)
{
    const char *text = a->site   ? nxc_race_text(a->site, a->site->variable)
                       : a->call ? a->call
                                 : "the message of an hrecv, which has interrupted the program";
    if (*text)
        fprintf(f, "\n  %s", text);
}

_Noreturn void asan_report(struct node *n, const struct asan_access *a)
{
    char *text = NULL;
    size_t size;
    uint8_t why = asan_shadow_why(&n->asan->shadow, a->bad);
    struct object o = object_of(n, a->bad, why);
    FILE *f = xchecked(open_memstream(&text, &size));
    fprintf(f, "%s: %s of %s, ", kind_of(why), a->write ? "write" : "read", bytes_text(a->bytes).text);
    print_position(f, n, a, why, &o);
    print_accessor(f, a);
    print_access(f, n, a);
    if (why == NXC_ASAN_HEAP || why == NXC_ASAN_FREED)
        print_block(f, n, asan_block_near(n, a->bad));
    print_advice(f, a, why, &o);
    fclose(f);
    node_fail_in(n, NULL, "%s", text);
}

_Noreturn void asan_report_block(struct node *n, const char *call, const void *block, const void *frame)
{
    char *text = NULL;
    size_t size;
    uintptr_t at = (uintptr_t)block;
    const struct asan_block *b = asan_block_near(n, at);
    bool again = b && asan_block_begin(b) == at;
    FILE *f = xchecked(open_memstream(&text, &size));
    fprintf(f, "%s: %s was given ", again ? "double-free" : "bad-free", call);
    if (again)
        fprintf(f, "a block of %s that is free already", bytes_text(b->bytes).text);
    else if (b)
        fprintf(
            f, "an address %s %s the beginning of a block of %s",
            bytes_text(at > asan_block_begin(b) ? at - asan_block_begin(b) : asan_block_begin(b) - at).text,
            at > asan_block_begin(b) ? "behind" : "before", bytes_text(b->bytes).text);
    else
        fprintf(f, "0x%zx, which is not of the heap", (size_t)at);
    print_stack(f, n, asan_stacks_at(n->asan->stacks, asan_stacks_here(n->asan->stacks, n, frame)));
    print_block(f, n, b);
    fprintf(f, "\n  to do: give %s what malloc has answered, once", call);
    fclose(f);
    node_fail_in(n, NULL, "%s", text);
}
