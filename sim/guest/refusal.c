/* refusal.c - see refusal.h. */
#include "guest/refusal.h"
#include <inttypes.h>
#include "files/number.h"
#include "guest/backtrace.h"
#include "guest/image.h"
#include "node/self.h"
#include "os/memory.h"

/* (Fortran's library gives its buffers back before an error is told.) */
bool refusal_was_last(const struct node *n)
{
    enum { BUFFERS = 1 << 16 };
    const struct node_refusal *r = &n->cold->refusal;
    return r->bytes > 0 && n->memory.heap <= r->heap && r->heap - n->memory.heap <= BUFFERS;
}

/* The innermost call that stands in the program's own code; its offset in the program. */
static size_t place_of(const struct node *n, const struct node_refusal *r)
{
    char line[200];
    for (int i = 0; i < r->depth; i++) {
        size_t at = r->returns[i] - 1 - (uintptr_t)n->guest.program;
        if (backtrace_in_program(n, r->returns[i] - 1) &&
            node_image_line(n->guest.file, at, line, sizeof line))
            return at;
    }
    return r->returns[0] - 1 - (uintptr_t)n->guest.program;
}

void refusal_print(FILE *f, const struct node *n)
{
    const struct node_refusal *r = &n->cold->refusal;
    double mb = 1 << 20, all = (double)node_memory_all(n) / mb;
    char where[256];
    if (r->bytes == 0)
        return;
    const char *call = r->depth > 0 ? backtrace_called(n, r->returns[0]) : NULL;
    fprintf(f, "\n  its memory was exhausted: %s of ", call ? call : "malloc");
    fputs(number_grouped(r->bytes).text, f);
    fprintf(f, " bytes was refused");
    if (r->depth > 0)
        fprintf(f, " in %s", node_image_where(n->guest.file, place_of(n, r), where, sizeof where));
    fprintf(f, ": %.1f of %.5g MB in use; ", (double)r->used / mb, all);
    if ((double)r->used + (double)r->bytes > all * mb)
        fprintf(f, "--set %s=N gives more", n->is_host ? "host.memory_mb" : "node.memory_mb");
    else
        fprintf(f, "this computer has addresses for %.5g MB a node, with so many nodes",
                (double)n->guest.region->heap_bytes / mb);
}
