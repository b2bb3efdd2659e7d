/* listening.c - see listening.h. */
#include "lab/serve/listening.h"
#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include "kernel/xalloc.h"

enum { BACKLOG = 512, DESCRIPTORS = 2048 };

union any {
    struct sockaddr base;
    struct sockaddr_in four;
    struct sockaddr_in6 six;
};

/* Returns the size of the address; 0: it is none. */
static socklen_t read_address(const char *text, unsigned port, union any *a)
{
    memset(a, 0, sizeof *a);
    if (inet_pton(AF_INET, text, &a->four.sin_addr) == 1) {
        a->four.sin_family = AF_INET;
        a->four.sin_port = htons((uint16_t)port);
        return sizeof a->four;
    }
    if (inet_pton(AF_INET6, text, &a->six.sin6_addr) == 1) {
        a->six.sin6_family = AF_INET6;
        a->six.sin6_port = htons((uint16_t)port);
        return sizeof a->six;
    }
    return 0;
}

static char *why_not(const char *address, unsigned port)
{
    if (errno == EADDRINUSE)
        return xasprintf(
            "port %u of %s is taken by another program (a touchstone serve that still runs?): end it, "
            "or give another port by --port, or none for any free one",
            port, address);
    if (errno == EACCES)
        return xasprintf(
            "port %u is not for ordinary users: give one from 1024 on by --port, or none for any free "
            "one",
            port);
    if (errno == EADDRNOTAVAIL)
        return xasprintf("%s is no address of this computer (see: ip address)", address);
    return xasprintf("%s, port %u: %s", address, port, strerror(errno));
}

struct evconnlistener *listening_at(struct event_base *base, const char *address, unsigned *port,
                                    char **error)
{
    union any a;
    socklen_t size = read_address(address, *port, &a);
    if (!size)
        return *error = xasprintf("'%s' is no address, such as 127.0.0.1 or ::1", address), NULL;
    struct evconnlistener *l = evconnlistener_new_bind(
        base, NULL, NULL, LEV_OPT_CLOSE_ON_FREE | LEV_OPT_CLOSE_ON_EXEC | LEV_OPT_REUSEABLE, BACKLOG, &a.base,
        (int)size);
    if (!l)
        return *error = why_not(address, *port), NULL;
    getsockname(evconnlistener_get_fd(l), &a.base, &size);
    *port = ntohs(a.base.sa_family == AF_INET ? a.four.sin_port : a.six.sin6_port);
    return l;
}

bool listening_is_local(const char *address)
{
    return !strncmp(address, "127.", 4) || !strcmp(address, "::1");
}

bool listening_is_everywhere(const char *address)
{
    return !strcmp(address, "0.0.0.0") || !strcmp(address, "::");
}

void listening_raise_limit(void)
{
    struct rlimit l;
    if (getrlimit(RLIMIT_NOFILE, &l) != 0 || l.rlim_cur >= DESCRIPTORS)
        return;
    l.rlim_cur = l.rlim_max < DESCRIPTORS ? l.rlim_max : DESCRIPTORS;
    setrlimit(RLIMIT_NOFILE, &l);
}
