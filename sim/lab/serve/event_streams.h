/* event_streams.h - server-sent events: a text to all pages that listen, when it has changed, and a sign of
 * life every ten seconds. */
#ifndef LAB_SERVE_EVENT_STREAMS_H
#define LAB_SERVE_EVENT_STREAMS_H
#include <event2/http.h>
#include <stdbool.h>

enum { STREAM_MOST = 32 };

struct event_streams;

struct event_streams *event_streams_new(void);
/* Frees what evhttp_free() has left: call it behind that. */
void event_streams_free(struct event_streams *e);

/* Answers the request with a stream that begins with the present text. False if there are too many. */
bool event_streams_add(struct event_streams *e, struct evhttp_request *request);
/* Sends a line of text to all unless it is the text that they have. Call it once a second. */
void event_streams_send(struct event_streams *e, const char *text);
#endif
