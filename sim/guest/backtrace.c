/* backtrace.c - see backtrace.h. */
#include "guest/backtrace.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "guest/exports.h"
#include "guest/image.h"
#include "guest/layer.h"
#include "node/self.h"

enum { MOST_CALLS = 24 };

static bool lies_in(uintptr_t address, const char *begin, size_t bytes)
{
    return address >= (uintptr_t)begin && address + 2 * sizeof(uintptr_t) <= (uintptr_t)begin + bytes;
}

/* A program may also have stacks of its own making, in its data or heap. */
bool backtrace_in_stack(const struct node *n, uintptr_t address)
{
    return lies_in(address, n->guest.stack, n->guest.stack_bytes) ||
           lies_in(address, n->guest.system_stack, NODE_SYSTEM_STACK) ||
           lies_in(address, n->guest.program, n->guest.image_bytes) ||
           lies_in(address, n->guest.heap_start, n->memory.heap);
}

/* A frame's return address; *frame becomes the caller's frame, 0 behind the last. False: there is none. */
static bool next_call(const struct node *n, uintptr_t *frame, uintptr_t *returns)
{
    uintptr_t at = *frame;
    if (at % sizeof at != 0 || !backtrace_in_stack(n, at))
        return false;
    *returns = ((uintptr_t *)at)[1];
    *frame = ((uintptr_t *)at)[0] > at ? ((uintptr_t *)at)[0] : 0;
    return true;
}

int backtrace_walk(const struct node *n, uintptr_t frame, uintptr_t *returns, int most)
{
    int depth = 0;
    while (depth < most && next_call(n, &frame, &returns[depth]))
        depth++;
    return depth;
}

bool backtrace_in_program(const struct node *n, uintptr_t address)
{
    return address - (uintptr_t)n->guest.program < n->guest.image_bytes;
}

int backtrace_program_calls(const struct node *n, uintptr_t frame, void **returns, int most)
{
    int depth = 0;
    uintptr_t address;
    while (depth < most && next_call(n, &frame, &address))
        if (backtrace_in_program(n, address))
            returns[depth++] = (void *)address;
    return depth;
}

static bool print_call(FILE *f, const struct node *n, const char *how, uintptr_t address)
{
    char where[256];
    if (!backtrace_in_program(n, address))
        return false;
    fprintf(f, "\n  %s %s", how,
            node_image_where(n->guest.file, address - (uintptr_t)n->guest.program, where, sizeof where));
    return true;
}

void backtrace_print_as(backtrace_print_call *print, FILE *f, const struct node *n, const char *how,
                        const uintptr_t *addresses, int count)
{
    for (int i = 0, equal; i < count; i += equal, how = "called from") {
        for (equal = 1; i + equal < count && addresses[i + equal] == addresses[i];)
            equal++;
        if (print(f, n, how, addresses[i]) && equal > 1)
            fprintf(f, ", %s%d times", i + equal == count ? "at least " : "", equal);
    }
}

void backtrace_print(FILE *f, const struct node *n, const char *how, const uintptr_t *addresses, int count)
{
    backtrace_print_as(print_call, f, n, how, addresses, count);
}

/* How many calls, the innermost first, are not the program's own: of `such` a library, or outside. */
static int library_calls(const struct node *n, const uintptr_t *addresses, int count,
                         bool (*such)(const struct node_image *img, size_t offset))
{
    int i = 0;
    while (i < count && (!backtrace_in_program(n, addresses[i]) ||
                         such(n->guest.file, addresses[i] - (uintptr_t)n->guest.program)))
        i++;
    return i;
}

/* (How the libraries are made is no concern of the program's.) */
void backtrace_print_calls(FILE *f, const struct node *n, uintptr_t frame)
{
    uintptr_t returns[MOST_CALLS];
    int depth = backtrace_walk(n, frame, returns, MOST_CALLS);
    for (int i = 0; i < depth; i++)
        returns[i]--; /* into the call */
    int first = library_calls(n, returns, depth, node_image_in_library);
    first = first < depth ? first : 0;
    backtrace_print(f, n, "called from", returns + first, depth - first);
}

const char *backtrace_mpi_call(const struct node *n, const uintptr_t *frames, int depth, int *outside)
{
    const char *call = NULL;
    *outside = library_calls(n, frames, depth, node_image_in_mpi);
    for (int i = 0; i < *outside; i++) {
        const char *name =
            backtrace_in_program(n, frames[i])
                ? node_image_function_name(n->guest.file, frames[i] - (uintptr_t)n->guest.program)
                : NULL;
        if (name && strncmp(name, "PMPI_", 5) == 0)
            call = layer_called(name);
    }
    return call;
}

/* The word that an instruction addresses relative to the next instruction; 0 if the word is not in the
 * program. */
static uintptr_t word_at(const struct node *n, uintptr_t next)
{
    int32_t away;
    uintptr_t word;
    memcpy(&away, (void *)(next - sizeof away), sizeof away);
    uintptr_t slot = next + (uintptr_t)(intptr_t)away;
    if (!backtrace_in_program(n, slot) || !backtrace_in_program(n, slot + sizeof word - 1))
        return 0;
    memcpy(&word, (void *)slot, sizeof word);
    return word;
}

/* The target of a stub as the linker makes it, a jump to where a word says: ENDBR64 perhaps, BND perhaps,
 * JMP. 0: the code is no stub. */
static uintptr_t stub_target(const struct node *n, uintptr_t at)
{
    static const unsigned char ENDBR64[] = {0xf3, 0x0f, 0x1e, 0xfa};
    const unsigned char *code = (const unsigned char *)at;
    if (!backtrace_in_program(n, at) || !backtrace_in_program(n, at + 16))
        return 0;
    if (memcmp(code, ENDBR64, sizeof ENDBR64) == 0)
        code += sizeof ENDBR64;
    if (*code == 0xf2)
        code++;
    return code[0] == 0xff && code[1] == 0x25 ? word_at(n, (uintptr_t)code + 6) : 0;
}

const char *backtrace_called(const struct node *n, uintptr_t returns)
{
    if (!backtrace_in_program(n, returns - 6) || !backtrace_in_program(n, returns))
        return NULL;
    const unsigned char *end = (const unsigned char *)returns;
    uintptr_t target = 0;
    if (end[-6] == 0xff && end[-5] == 0x15) { /* CALL to where a word says */
        target = word_at(n, returns);
    } else if (end[-5] == 0xe8) {
        int32_t away;
        memcpy(&away, end - sizeof away, sizeof away);
        target = stub_target(n, returns + (uintptr_t)(intptr_t)away);
    }
    return target ? node_export_name(target) : NULL;
}

/* --- lines --- */

enum { BUCKETS = 64 };

struct found {
    struct found *next;
    const struct node_image *file;
    uintptr_t offset;
    char text[100];    /* "": not known, or in NX's library */
    char outside[100]; /* of the program's message layer, if functions are inlined; "": nothing is */
};

struct backtrace_lines {
    struct found *bucket[BUCKETS];
};

struct backtrace_lines *backtrace_lines_new(void)
{
    return xcalloc(1, sizeof(struct backtrace_lines));
}

void backtrace_lines_free(struct backtrace_lines *t)
{
    for (int i = 0; t && i < BUCKETS; i++)
        for (struct found *f = t->bucket[i], *next; f; f = next) {
            next = f->next;
            free(f);
        }
    free(t);
}

static const struct found *found_at(struct backtrace_lines *t, const struct node_image *file,
                                    uintptr_t offset)
{
    struct found **first = &t->bucket[offset % BUCKETS];
    for (struct found *f = *first; f; f = f->next)
        if (f->file == file && f->offset == offset)
            return f;
    struct found *f = xcalloc(1, sizeof *f);
    *f = (struct found){.next = *first, .file = file, .offset = offset};
    if (!node_image_line(file, offset, f->text, sizeof f->text))
        f->text[0] = '\0';
    if (!node_image_line_outside(file, offset, f->outside, sizeof f->outside))
        f->outside[0] = '\0';
    return *first = f;
}

/* NULL: the line is not known, or is in NX's library. */
static const struct found *line_at(struct backtrace_lines *t, const struct node *n, uintptr_t address)
{
    if (!backtrace_in_program(n, address - 1))
        return NULL;
    const struct found *f = found_at(t, n->guest.file, address - 1 - (uintptr_t)n->guest.program);
    return *f->text ? f : NULL;
}

const char *backtrace_line_at(struct backtrace_lines *t, const struct node *n, uintptr_t address)
{
    const struct found *f = line_at(t, n, address);
    return f ? f->text : NULL;
}

const char *backtrace_line_of(struct backtrace_lines *t, const struct node *n, const uintptr_t *returns,
                              int depth)
{
    const struct found *innermost = NULL;
    for (int i = 0; i < depth && returns[i]; i++) {
        const struct found *f = line_at(t, n, returns[i]);
        if (f && *f->outside)
            return f->outside;
        innermost = innermost ? innermost : f;
    }
    return innermost ? innermost->text : NULL;
}

const char *backtrace_line_from(struct backtrace_lines *t, const struct node *n, uintptr_t frame)
{
    uintptr_t returns[MOST_CALLS];
    int depth = backtrace_walk(n, frame, returns, MOST_CALLS);
    return backtrace_line_of(t, n, returns, depth);
}

const char *backtrace_line(struct backtrace_lines *t, const struct node *n)
{
    return backtrace_line_from(t, n, n->wait.frame);
}

const char *backtrace_line_away(struct backtrace_lines *t, const struct node *n)
{
    return backtrace_line_from(t, n, (uintptr_t)fiber_frame(&n->lp.fiber));
}
