/* frame.c - see frame.h. */
#include "srm/frame.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

void frame_head(unsigned char head[FRAME_HEAD], enum frame_kind kind, uint32_t length)
{
    head[0] = (unsigned char)kind;
    for (int i = 0; i < 4; i++)
        head[1 + i] = (unsigned char)(length >> (8 * i));
}

void frame_put(struct evbuffer *b, enum frame_kind kind, const void *bytes, uint32_t length)
{
    unsigned char head[FRAME_HEAD];
    frame_head(head, kind, length);
    evbuffer_add(b, head, sizeof head);
    evbuffer_add(b, bytes, length);
}

int frame_take(struct evbuffer *b, enum frame_kind *kind, char **bytes, uint32_t *length)
{
    unsigned char head[FRAME_HEAD];
    if (evbuffer_copyout(b, head, sizeof head) < FRAME_HEAD)
        return 0;
    *kind = head[0];
    *length = head[1] | (uint32_t)head[2] << 8 | (uint32_t)head[3] << 16 | (uint32_t)head[4] << 24;
    if (*length > FRAME_MOST || !strchr("ROEX", head[0]) || !head[0])
        return -1;
    if (evbuffer_get_length(b) < FRAME_HEAD + *length)
        return 0;
    *bytes = xmalloc(*length + 1);
    evbuffer_drain(b, FRAME_HEAD);
    evbuffer_remove(b, *bytes, *length);
    (*bytes)[*length] = 0;
    return 1;
}

void request_put(struct evbuffer *b, const struct request *r)
{
    const char *strings[REQUEST_STRINGS] = {r->command, r->folder, r->session, r->cube, r->type};
    struct evbuffer *all = xchecked(evbuffer_new());
    for (int i = 0; i < REQUEST_STRINGS; i++)
        evbuffer_add(all, strings[i], strlen(strings[i]) + 1);
    for (int i = 0; i < r->argc; i++)
        evbuffer_add(all, r->argv[i], strlen(r->argv[i]) + 1);
    uint32_t length = (uint32_t)evbuffer_get_length(all);
    frame_put(b, FRAME_REQUEST, evbuffer_pullup(all, -1), length);
    evbuffer_free(all);
}

bool request_read(struct request *r, char *bytes, uint32_t length)
{
    const char *strings[REQUEST_STRINGS];
    char *at = bytes, *end = bytes + length;
    if (length == 0 || end[-1])
        return false;
    int words = 0;
    for (const char *c = bytes; c < end; c++)
        words += *c == 0;
    if (words < REQUEST_STRINGS)
        return false;
    for (int i = 0; i < REQUEST_STRINGS; i++, at += strlen(at) + 1)
        strings[i] = at;
    *r = (struct request){strings[0], strings[1], strings[2], strings[3], strings[4], 0, NULL};
    r->argv = xcalloc((size_t)(words - REQUEST_STRINGS) + 1, sizeof *r->argv);
    for (; at < end; at += strlen(at) + 1)
        r->argv[r->argc++] = at;
    return true;
}
