/* frame.h - the frames that the service's socket carries both ways: a kind, a length and so many bytes.
 *
 *     client    FRAME_REQUEST   strings, each ended by 0: struct request in this order, then the program and
 *                               its arguments
 *     service   FRAME_OUT, FRAME_ERR   bytes for the client's standard output and error output
 *               FRAME_END       one byte: the client's exit status; the last
 */
#ifndef SRM_FRAME_H
#define SRM_FRAME_H
#include <event2/buffer.h>
#include <stdbool.h>
#include <stdint.h>

enum frame_kind { FRAME_REQUEST = 'R', FRAME_OUT = 'O', FRAME_ERR = 'E', FRAME_END = 'X' };
enum { FRAME_HEAD = 5, FRAME_MOST = 8 << 20 }; /* no command has longer arguments, by Linux */

struct request {
    const char *command; /* "getcube" */
    const char *folder;  /* the current folder of the client */
    const char *session; /* of the client's terminal, to which cubes are attached */
    const char *cube;    /* its name; "": the cube attached to the session */
    const char *type;    /* getcube */
    int argc;            /* load: words for touchstone run; cubeinfo: "json", or nothing for text */
    char **argv;
};
enum { REQUEST_STRINGS = 5 };

void frame_head(unsigned char head[FRAME_HEAD], enum frame_kind kind, uint32_t length);
void frame_put(struct evbuffer *b, enum frame_kind kind, const void *bytes, uint32_t length);
/* Takes a whole frame out of the buffer; *bytes is malloc'd, with a 0 after its end. Returns 1 if there was
 * one, 0 if more bytes have to come, -1 if the bytes are no frame. */
int frame_take(struct evbuffer *b, enum frame_kind *kind, char **bytes, uint32_t *length);

void request_put(struct evbuffer *b, const struct request *r);
/* Reads a request; its strings point into bytes, argv is malloc'd. Returns false if the bytes are no request.
 */
bool request_read(struct request *r, char *bytes, uint32_t length);
#endif
