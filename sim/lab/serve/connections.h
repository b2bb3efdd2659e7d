/* connections.h - keeps the connections to evhttp few and short-lived. evhttp has neither a limit on their
 * number, nor one on the time that a client may take for a request.
 *
 *     a connection without a request after CONNECTION_TO_ASK_S is shut down
 *     any connection is shut down after CONNECTION_TO_LIVE_S, but for those kept
 *     of more than CONNECTION_MOST, the oldest without a request is shut down, or else the oldest
 *
 * A connection that is shut down looks to evhttp as if its client had closed it. Connections are known by
 * their descriptors and sockets' numbers, since evhttp does not tell when one has ended. */
#ifndef LAB_SERVE_CONNECTIONS_H
#define LAB_SERVE_CONNECTIONS_H
#include <event2/http.h>
#include <stdbool.h>

enum { CONNECTION_MOST = 512, CONNECTION_TO_ASK_S = 5, CONNECTION_TO_LIVE_S = 120 };

struct connections;

/* Takes over evhttp's making of bufferevents (evhttp_set_bevcb()). */
struct connections *connections_new(struct evhttp *http, struct event_base *base);
void connections_free(struct connections *c);

/* Call when a connection has a request. keep: the connection may live as long as its client wants. */
void connections_asked(struct connections *c, struct evhttp_request *request, bool keep);
/* Call once a second: shuts down what is too old. */
void connections_sweep(struct connections *c);
#endif
