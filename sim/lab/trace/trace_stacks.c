/* trace_stacks.c - the stacks of programs at their calls: the stacks of a trace, and their frames'
 * functions and source lines, which are looked up in the programs' files when first asked for. */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "guest/elffile.h"
#include "guest/layer.h"
#include "kernel/xalloc.h"
#include "nx_api/waitfor/waitfor_mpi.h"
#include "lab/trace/program_code.h"
#include "lab/trace/trace_parts.h"

struct place {
    int64_t offset;        /* of the return address in the program */
    struct layer_place at; /* keeps the texts of */
    struct trace_frame frame;
};

struct program {
    char *path;
    struct elf_file *elf;
    bool tried;                /* to open it */
    struct program_code *code; /* NULL: nobody has asked */
    struct place **places;     /* sorted by offset */
    size_t count;
};

struct stack {
    int program, depth;
    int64_t *offsets;
    struct trace_frame *frames; /* NULL: nobody has asked */
};

struct trace_stacks {
    struct program *programs;
    struct stack *stacks;
    int program_count, stack_count;
};

struct trace_stacks *trace_stacks_new(void)
{
    return xcalloc(1, sizeof(struct trace_stacks));
}

static void free_program(struct program *p)
{
    for (size_t i = 0; i < p->count; i++) {
        free(p->places[i]->at.function);
        free(p->places[i]->at.path);
        free(p->places[i]);
    }
    free(p->places);
    program_code_free(p->code);
    if (p->elf)
        elf_close(p->elf);
    free(p->path);
}

void trace_stacks_free(struct trace_stacks *s)
{
    if (!s)
        return;
    for (int i = 0; i < s->program_count; i++)
        free_program(&s->programs[i]);
    for (int i = 0; i < s->stack_count; i++) {
        free(s->stacks[i].offsets);
        free(s->stacks[i].frames);
    }
    free(s->programs);
    free(s->stacks);
    free(s);
}

void trace_stacks_program(struct trace_stacks *s, const char *folder, const char *path)
{
    s->programs = xreallocarray(s->programs, (size_t)s->program_count + 1, sizeof *s->programs);
    s->programs[s->program_count++] =
        (struct program){.path = *path == '/' ? xstrdup(path) : xasprintf("%s/%s", folder, path)};
}

int trace_stacks_programs(const struct trace_stacks *s)
{
    return s->program_count;
}

int trace_stacks_count(const struct trace_stacks *s)
{
    return s->stack_count;
}

void trace_stacks_add(struct trace_stacks *s, int program, const int64_t *offsets, int depth)
{
    s->stacks = xgrown(s->stacks, (size_t)s->stack_count, sizeof *s->stacks);
    struct stack *k = &s->stacks[s->stack_count++];
    *k = (struct stack){.program = program, .depth = depth};
    k->offsets = xcalloc((size_t)depth, sizeof *k->offsets);
    memcpy(k->offsets, offsets, (size_t)depth * sizeof *offsets);
}

static bool is_younger(const char *path, const struct timespec *than)
{
    struct stat st;
    if (stat(path, &st))
        return false;
    const struct timespec *at = &st.st_mtim;
    return at->tv_sec > than->tv_sec || (at->tv_sec == than->tv_sec && at->tv_nsec > than->tv_nsec);
}

const char *trace_missing_program(const struct trace *t)
{
    const struct trace_stacks *s = t->stacks;
    for (int i = 0; i < s->program_count; i++)
        if (access(s->programs[i].path, R_OK))
            return s->programs[i].path;
    return NULL;
}

const char *trace_younger_program(const struct trace *t, const char *path)
{
    const struct trace_stacks *s = t->stacks;
    struct stat st;
    if (stat(path, &st))
        return NULL;
    for (int i = 0; i < s->program_count; i++)
        if (is_younger(s->programs[i].path, &st.st_mtim))
            return s->programs[i].path;
    return NULL;
}

/* --- looking up --- */

static const struct elf_file *opened(struct program *p)
{
    if (!p->tried) {
        char *error = NULL;
        p->tried = true;
        p->elf = elf_open(p->path, &error);
        free(error); /* frames without names tell */
    }
    return p->elf;
}

static struct trace_frame frame_of(const struct layer_place *at)
{
    struct trace_frame frame = {.function = at->function, .line = at->line, .layer = at->in_layer};
    frame.library = !strncmp(at->function, "nxc_", 4); /* from a program that computes to the simulator */
    if (!at->path)
        return frame;
    frame.library = frame.library || layer_is_library(at->path);
    if (frame.library)
        frame.function = layer_called(at->function);
    frame.file = basename(at->path);
    return frame;
}

/* Where the offset is, or belongs, among the places. */
static size_t position(const struct program *p, int64_t offset)
{
    size_t low = 0, high = p->count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (p->places[middle]->offset < offset)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* The frame whose call returns to the offset. */
static struct trace_frame frame_at(struct program *p, const struct elf_file *f, char *const *layer,
                                   int64_t offset)
{
    size_t at = position(p, offset);
    if (at < p->count && p->places[at]->offset == offset)
        return p->places[at]->frame;
    p->places = xgrown(p->places, p->count, sizeof *p->places);
    memmove(p->places + at + 1, p->places + at, (p->count++ - at) * sizeof *p->places);
    struct place *place = p->places[at] = xmalloc(sizeof *place);
    place->offset = offset;
    place->at = layer_place(f, layer, (uint64_t)offset - 1);
    place->frame = frame_of(&place->at);
    place->frame.returns_to = offset;
    return place->frame;
}

const struct trace_frame *trace_stack(const struct trace *t, int32_t stack, int *count)
{
    *count = 0;
    if (stack == TRACE_NONE || !t->stacks)
        return NULL;
    struct stack *k = &t->stacks->stacks[stack];
    struct program *p = &t->stacks->programs[k->program];
    const struct elf_file *f = opened(p);
    if (!f)
        return NULL;
    if (!k->frames) {
        k->frames = xcalloc((size_t)k->depth, sizeof *k->frames);
        for (int i = 0; i < k->depth; i++)
            k->frames[i] = frame_at(p, f, t->layer, k->offsets[i]);
    }
    *count = k->depth;
    return k->frames;
}

const struct elf_file *trace_stack_file(const struct trace *t, int32_t stack)
{
    return opened(&t->stacks->programs[t->stacks->stacks[stack].program]);
}

const struct program_code *trace_stack_code(const struct trace *t, int32_t stack)
{
    struct program *p = &t->stacks->programs[t->stacks->stacks[stack].program];
    if (!p->code)
        p->code = program_code_read(p->path);
    return p->code;
}

struct trace_frame trace_frame_at(const struct trace *t, int32_t stack, int64_t offset)
{
    struct program *p = &t->stacks->programs[t->stacks->stacks[stack].program];
    return frame_at(p, opened(p), t->layer, offset);
}

const struct trace_frame *trace_place(const struct trace *t, int32_t stack)
{
    int count;
    const struct trace_frame *frames = trace_stack(t, stack, &count);
    const struct trace_frame *innermost = NULL;
    for (int i = 0; i < count; i++) {
        if (frames[i].library || !*frames[i].function)
            continue;
        if (!frames[i].layer)
            return &frames[i];
        innermost = innermost ? innermost : &frames[i];
    }
    return innermost;
}

const char *trace_called_name(const struct trace *t, const struct trace_call *c)
{
    int count;
    const struct trace_frame *frames = trace_stack(t, c->stack, &count);
    const char *own = t->names[c->name], *name = own;
    for (int i = 0; i < count && frames[i].library; i++)
        if (*frames[i].function)
            name = frames[i].function;
    /* (MPI's collectives that go on in another call have stacks of their own.) */
    bool inside = strncmp(own, "MPI_", 4) == 0 && strncmp(name, "MPI_", 4) != 0;
    return inside ? own : name;
}

bool trace_takes_id(const struct trace *t, const struct trace_call *c)
{
    const char *name = t->names[c->name];
    name += *name == '_';
    return !strncmp(name, "msg", 3) || !strncmp(name, "io", 2);
}

char *trace_communicator(int32_t pid)
{
    char *text = NULL;
    size_t size;
    if (!waitfor_is_mpi(pid))
        return NULL;
    FILE *f = xchecked(open_memstream(&text, &size));
    waitfor_print_communicator(f, pid);
    fclose(f);
    return text;
}
