/* event_streams.c - see event_streams.h. */
#include "lab/serve/event_streams.h"
#include <event2/buffer.h>
#include <event2/bufferevent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include "kernel/xalloc.h"

enum { SIGN_EVERY = 10, MOST_UNSENT = 1 << 18, A_DAY = 86400 };

struct stream {
    struct event_streams *of;
    struct evhttp_request *request;
    struct stream *next;
};

struct event_streams {
    struct stream *first;
    size_t count;
    char *text;
    unsigned seconds; /* since something was sent */
};

struct event_streams *event_streams_new(void)
{
    struct event_streams *e = xcalloc(1, sizeof *e);
    e->text = xstrdup("{}");
    return e;
}

/* The connection has ended. If its client ended it, evhttp has taken the request from it and forgotten the
 * request; otherwise evhttp is about to free the request. */
static void on_end(struct evhttp_connection *connection, void *arg)
{
    struct stream *s = arg, **at = &s->of->first;
    (void)connection;
    while (*at != s)
        at = &(*at)->next;
    *at = s->next;
    s->of->count--;
    if (!evhttp_request_get_connection(s->request))
        evhttp_request_free(s->request);
    free(s);
}

void event_streams_free(struct event_streams *e)
{
    free(e->text);
    free(e);
}

static void send_to(struct stream *s, const char *before, const char *text)
{
    struct evhttp_connection *c = evhttp_request_get_connection(s->request);
    struct bufferevent *b = evhttp_connection_get_bufferevent(c);
    if (evbuffer_get_length(bufferevent_get_output(b)) > MOST_UNSENT) {
        shutdown(bufferevent_getfd(b), SHUT_RDWR); /* it does not read */
        return;
    }
    struct evbuffer *line = xchecked(evbuffer_new());
    evbuffer_add_printf(line, "%s%s\n\n", before, text);
    evhttp_send_reply_chunk(s->request, line);
    evbuffer_free(line);
}

bool event_streams_add(struct event_streams *e, struct evhttp_request *request)
{
    struct evhttp_connection *c = evhttp_request_get_connection(request);
    if (e->count == STREAM_MOST)
        return false;
    struct stream *s = xmalloc(sizeof *s);
    *s = (struct stream){e, request, e->first};
    e->first = s;
    e->count++;
    evhttp_connection_set_closecb(c, on_end, s);
    evhttp_connection_set_timeout(c, A_DAY);
    evhttp_add_header(evhttp_request_get_output_headers(request), "Content-Type", "text/event-stream");
    evhttp_send_reply_start(request, HTTP_OK, "OK");
    send_to(s, "data: ", e->text);
    return true;
}

void event_streams_send(struct event_streams *e, const char *text)
{
    bool changed = strcmp(text, e->text);
    if (!changed && ++e->seconds < SIGN_EVERY)
        return;
    e->seconds = 0;
    if (changed) {
        free(e->text);
        e->text = xstrdup(text);
    }
    for (struct stream *s = e->first, *next; s; s = next) {
        next = s->next;
        send_to(s, changed ? "data: " : ": ", changed ? text : "alive");
    }
}
