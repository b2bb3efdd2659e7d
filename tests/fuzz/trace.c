/* trace.c - traces (lab/trace/trace_model.h), given without their first line and before compression, and what
 * explains them. */
#include <stdlib.h>
#include <string.h>
#include <zstd.h>
#include "fuzz.h"
#include "kernel/xalloc.h"
#include "lab/why/why.h"
#include "trace/trace_format.h"

static void write_trace(const uint8_t *bytes, size_t size)
{
    const size_t head = sizeof TRACE_MAGIC - 1, room = ZSTD_compressBound(size);
    char *all = xmalloc(head + room);
    memcpy(all, TRACE_MAGIC, head);
    size_t packed = ZSTD_compress(all + head, room, bytes, size, -20);
    if (ZSTD_isError(packed))
        abort();
    fuzz_file("fuzzed.trace", all, head + packed);
    free(all);
}

static void use(void *arg, uint32_t channel, int32_t message, vtime begin, vtime end)
{
    const struct trace *t = arg;
    char name[64];
    (void)begin, (void)end;
    if (message < 0 || message >= t->message_count)
        abort();
    trace_channel_name(t, channel, name, sizeof name);
}

static void look(const struct trace *t)
{
    struct trace_pieces p = {0};
    for (int32_t i = 0; i < t->node_count && i < 64; i++)
        trace_pieces(t, i, &p);
    free(p.list);
    trace_channel_uses(t, use, (void *)(uintptr_t)t);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char *path = fuzz_path("fuzzed.trace"), *error = NULL;
    write_trace(bytes, size);
    struct trace *t = trace_load(path, NULL, &error);
    if (t) {
        look(t);
        why_free(why_new(t, NULL));
    } else {
        fuzz_refused(error, path);
    }
    free(path);
    return 0;
}
