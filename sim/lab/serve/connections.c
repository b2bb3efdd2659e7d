/* connections.c - see connections.h. */
#include "lab/serve/connections.h"
#include <event2/bufferevent.h>
#include <event2/event.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include "kernel/hostclock.h"
#include "kernel/xalloc.h"

struct connection {
    int fd;
    ino_t socket; /* the socket's number: a later connection may have the same descriptor */
    double since_s;
    bool asked, kept, down;
};

struct connections {
    struct event_base *base;
    struct connection *list; /* the oldest first */
    size_t count, room;
    struct bufferevent **fresh; /* made for connections whose descriptor is not known yet */
    size_t fresh_count, fresh_room;
};

static bool is_open(const struct connection *c)
{
    struct stat st;
    return fstat(c->fd, &st) == 0 && st.st_ino == c->socket;
}

static void shut_down(struct connection *c)
{
    if (!c->down)
        shutdown(c->fd, SHUT_RDWR);
    c->down = true;
}

/* Forgets connections that have ended. */
static void forget_ended(struct connections *c)
{
    size_t left = 0;
    for (size_t i = 0; i < c->count; i++)
        if (is_open(&c->list[i]))
            c->list[left++] = c->list[i];
    c->count = left;
}

/* Shuts down one of too many: the oldest that has asked for nothing, else the oldest that is not kept, else
 * the oldest. */
static void make_room(struct connections *c)
{
    struct connection *idle = NULL, *passing = NULL, *any = NULL;
    size_t up = 0;
    forget_ended(c);
    for (size_t i = c->count; i-- > 0;) {
        struct connection *one = &c->list[i];
        if (one->down)
            continue;
        up++;
        any = one;
        passing = one->kept ? passing : one;
        idle = one->asked ? idle : one;
    }
    if (up > CONNECTION_MOST)
        shut_down(idle ? idle : passing ? passing : any);
}

static void note(struct connections *c, int fd)
{
    struct stat st;
    if (fd < 0 || fstat(fd, &st) != 0)
        return;
    if (c->count == c->room)
        c->list = xreallocarray(c->list, c->room = 2 * c->room + 16, sizeof *c->list);
    c->list[c->count++] = (struct connection){.fd = fd, .socket = st.st_ino, .since_s = hostclock_s()};
    if (c->count > CONNECTION_MOST)
        make_room(c);
}

/* evhttp has given the bufferevents their descriptors meanwhile, and read nothing yet. */
static void on_fresh(evutil_socket_t none, short what, void *arg)
{
    struct connections *c = arg;
    (void)none, (void)what;
    for (size_t i = 0; i < c->fresh_count; i++)
        note(c, bufferevent_getfd(c->fresh[i]));
    c->fresh_count = 0;
}

static struct bufferevent *on_connection(struct event_base *base, void *arg)
{
    static const struct timeval now = {0, 0};
    struct connections *c = arg;
    struct bufferevent *b = bufferevent_socket_new(base, -1, 0);
    if (!b)
        return NULL;
    if (c->fresh_count == 0)
        event_base_once(base, -1, EV_TIMEOUT, on_fresh, c, &now);
    if (c->fresh_count == c->fresh_room)
        c->fresh = xreallocarray(c->fresh, c->fresh_room = 2 * c->fresh_room + 16, sizeof(void *));
    c->fresh[c->fresh_count++] = b;
    return b;
}

struct connections *connections_new(struct evhttp *http, struct event_base *base)
{
    struct connections *c = xcalloc(1, sizeof *c);
    c->base = base;
    evhttp_set_bevcb(http, on_connection, c);
    return c;
}

void connections_free(struct connections *c)
{
    free(c->list);
    free(c->fresh);
    free(c);
}

void connections_asked(struct connections *c, struct evhttp_request *request, bool keep)
{
    struct evhttp_connection *from = evhttp_request_get_connection(request);
    int fd = bufferevent_getfd(evhttp_connection_get_bufferevent(from));
    for (size_t i = c->count; i-- > 0;)
        if (c->list[i].fd == fd && is_open(&c->list[i])) {
            c->list[i].asked = true;
            c->list[i].kept |= keep;
            return;
        }
}

void connections_sweep(struct connections *c)
{
    double now = hostclock_s();
    forget_ended(c);
    for (size_t i = 0; i < c->count; i++) {
        struct connection *one = &c->list[i];
        double age = now - one->since_s;
        if (!one->kept && age > (one->asked ? CONNECTION_TO_LIVE_S : CONNECTION_TO_ASK_S))
            shut_down(one);
    }
}
