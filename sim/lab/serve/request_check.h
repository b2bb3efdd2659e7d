/* request_check.h - the check of whether a request may be answered. Another program or web page of the same
 * computer, or one on the network, must get nothing:
 *
 *     Host      exactly one, an address or name of this server with its port; a name that somebody else has
 *               made lead here (DNS rebinding) is not
 *     Origin    if given, the server itself; must be given with what changes something
 *     token     ?token=, which only the printed address has; compared in constant time
 *     path      one of the server's; method: the path's; size of the body: evhttp's limits
 */
#ifndef LAB_SERVE_REQUEST_CHECK_H
#define LAB_SERVE_REQUEST_CHECK_H
#include <event2/http.h>
#include <stdbool.h>

enum { TOKEN_DIGITS = 32 };

struct server_name {
    char *address; /* what the server listens at */
    unsigned port;
    bool everywhere; /* the address stands for all of this computer's */
    char token[TOKEN_DIGITS + 1];
};

/* Makes a token of the system's random numbers. */
bool token_make(char token[TOKEN_DIGITS + 1]);

/* What is wrong with the request, with the status of HTTP to answer; NULL if nothing is. Neither path nor
 * method is looked at. */
const char *request_wrong(struct evhttp_request *request, const struct server_name *s, int *status);
#endif
