/* listening.h - a socket that listens at an address. */
#ifndef LAB_SERVE_LISTENING_H
#define LAB_SERVE_LISTENING_H
#include <event2/listener.h>
#include <stdbool.h>

/* Listens at an address of this computer, a number as 127.0.0.1 or ::1. *port 0 becomes the free one that was
 * found. NULL with *error malloc'd. */
struct evconnlistener *listening_at(struct event_base *base, const char *address, unsigned *port,
                                    char **error);
/* Is the address one that only this computer reaches? */
bool listening_is_local(const char *address);
/* Does it stand for all addresses of this computer? */
bool listening_is_everywhere(const char *address);
/* Lets this process have as many connections as the system allows, up to what the server can use. */
void listening_raise_limit(void);
#endif
