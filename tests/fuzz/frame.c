/* frame.c - what comes from a client on the socket of touchstone srm (srm/frame.h). */
#include "srm/frame.h"
#include <stdlib.h>
#include <string.h>
#include "fuzz.h"
#include "kernel/xalloc.h"

/* A request that was read is the same when it is written and read again. */
static void read_request(char *bytes, uint32_t length)
{
    struct request r, again;
    if (!request_read(&r, bytes, length))
        return;
    struct evbuffer *b = xchecked(evbuffer_new());
    enum frame_kind kind;
    char *copy;
    request_put(b, &r);
    if (frame_take(b, &kind, &copy, &length) != 1 || kind != FRAME_REQUEST ||
        !request_read(&again, copy, length) || again.argc != r.argc || strcmp(again.cube, r.cube) != 0)
        abort();
    free(again.argv);
    free(r.argv);
    free(copy);
    evbuffer_free(b);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct evbuffer *b = xchecked(evbuffer_new());
    enum frame_kind kind;
    char *frame;
    uint32_t length;
    evbuffer_add(b, bytes, size);
    while (frame_take(b, &kind, &frame, &length) == 1) {
        if (kind == FRAME_REQUEST)
            read_request(frame, length);
        free(frame);
    }
    evbuffer_free(b);
    return 0;
}
