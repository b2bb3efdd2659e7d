/* trace_parts.h - what the files of this folder share, and nobody else: a trace that is being read. */
#ifndef LAB_TRACE_PARTS_H
#define LAB_TRACE_PARTS_H
#include "lab/trace/trace_model.h"
#include "trace/unpacker.h"

/* How the file refers to messages: what the entry `index` of a table is, sends, takes or handles. */
enum link_kind { LINK_IS, LINK_SENDS, LINK_TAKES, LINK_HANDLES };
struct link {
    enum link_kind kind;
    int32_t index;
    uint32_t source;
    uint64_t order, count;
    vtime at; /* when taken */
};

struct loading {
    struct trace *t;
    const struct trace_selection *selection;
    struct unpacker *in;
    bool bad;
    struct link *links;
    size_t link_count;
    vtime *last, *last_system, last_sent; /* by node: what the next record's time is told from */
};

/* trace_load.c */
int32_t trace_node_at(const struct trace *t, uint32_t address);
/* trace_connect.c: sorts the tables, and replaces names of messages by indexes. */
void trace_connect(struct loading *l);
enum trace_class trace_class_of(const char *call);

/* trace_stacks.c */
struct program_code;
struct trace_stacks *trace_stacks_new(void);
void trace_stacks_free(struct trace_stacks *s);
/* A program of the run, whose path may be relative to the run's folder; numbered from 0. */
void trace_stacks_program(struct trace_stacks *s, const char *folder, const char *path);
int trace_stacks_programs(const struct trace_stacks *s);
void trace_stacks_add(struct trace_stacks *s, int program, const int64_t *offsets, int depth);
int trace_stacks_count(const struct trace_stacks *s);
/* The program of a stack, which trace_stack() has opened; its code, read when first asked for; a frame of
 * this program whose call returns to the offset. */
const struct elf_file *trace_stack_file(const struct trace *t, int32_t stack);
const struct program_code *trace_stack_code(const struct trace *t, int32_t stack);
struct trace_frame trace_frame_at(const struct trace *t, int32_t stack, int64_t offset);
#endif
