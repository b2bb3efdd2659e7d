/* client.c - see client.h. */
#include "srm/client.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/xalloc.h"
#include "srm/socket.h"

/* Writes a frame's bytes where they belong. Returns true after the last frame. */
static bool write_frame(enum frame_kind kind, const char *bytes, uint32_t length, FILE *out, int *status)
{
    if (kind == FRAME_END && length == 1) {
        *status = (unsigned char)bytes[0];
        return true;
    }
    FILE *to = kind == FRAME_ERR ? stderr : out;
    fwrite(bytes, 1, length, to);
    fflush(to);
    return false;
}

/* Returns the status of the answer; -1 if the answer breaks off. */
static int read_answer(int fd, FILE *out)
{
    struct evbuffer *in = xchecked(evbuffer_new());
    enum frame_kind kind;
    char *bytes;
    uint32_t length;
    int status = -1, taken = 0;
    bool last = false;
    while (!last && taken >= 0 && evbuffer_read(in, fd, -1) > 0)
        while (!last && (taken = frame_take(in, &kind, &bytes, &length)) > 0) {
            last = write_frame(kind, bytes, length, out, &status);
            free(bytes);
        }
    evbuffer_free(in);
    return status;
}

int client_ask(const char *path, const struct request *r, FILE *out, char **error)
{
    int fd, status = -1;
    *error = socket_connect(path, &fd);
    if (*error)
        return -1;
    struct evbuffer *asked = xchecked(evbuffer_new());
    request_put(asked, r);
    bool sent = true;
    while (sent && evbuffer_get_length(asked) > 0)
        sent = evbuffer_write(asked, fd) > 0;
    evbuffer_free(asked);
    if (sent)
        status = read_answer(fd, out);
    close(fd);
    if (status < 0)
        *error = xstrdup("the service has gone away: touchstone srm starts one; its cubes are gone too");
    return status;
}
