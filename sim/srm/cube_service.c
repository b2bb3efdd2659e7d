/* cube_service.c - see cube_service.h. One thread, on libevent: a listening socket, clients, running
 * programs, signals. A client makes one request and gets its answer; the answer to waitcube takes as long as
 * the program. */
#include "srm/cube_service.h"
#include <event2/bufferevent.h>
#include <event2/event.h>
#include <event2/listener.h>
#include <pwd.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include "kernel/xalloc.h"
#include "srm/cubes.h"
#include "srm/frame.h"
#include "srm/job.h"

struct service;

struct client {
    struct service *service;
    struct bufferevent *link;
    char owner[CUBE_TEXT];
    struct job *awaited; /* by waitcube; NULL: none */
    off_t at;            /* so much of its output has been sent */
    bool answered;       /* to be closed when all is written */
    struct client *next, **where;
};

struct service {
    struct service_options options;
    struct event_base *base;
    struct cubes cubes;
    struct client *clients;
};

enum { WRITE_AHEAD = 1 << 16 }; /* bytes of output that wait for a slow client */

/* --- the log --- */

__attribute__((format(printf, 2, 3))) static void note(const struct service *s, const char *format, ...)
{
    char when[32];
    time_t now = time(NULL);
    struct tm tm;
    va_list list;
    localtime_r(&now, &tm);
    strftime(when, sizeof when, "%Y-%m-%d %H:%M:%S", &tm);
    fprintf(s->options.log, "%s ", when);
    va_start(list, format);
    vfprintf(s->options.log, format, list);
    va_end(list);
    fputc('\n', s->options.log);
    fflush(s->options.log);
}

/* --- answers --- */

static void client_free(struct client *c)
{
    *c->where = c->next;
    if (c->next)
        c->next->where = c->where;
    bufferevent_free(c->link);
    free(c);
}

static void say(struct client *c, enum frame_kind kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
static void say(struct client *c, enum frame_kind kind, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    char *text = xvasprintf(format, list);
    va_end(list);
    frame_put(bufferevent_get_output(c->link), kind, text, (uint32_t)strlen(text));
    free(text);
}

/* Ends the answer with the client's exit status. */
static void end(struct client *c, int status)
{
    unsigned char byte = (unsigned char)status;
    frame_put(bufferevent_get_output(c->link), FRAME_END, &byte, 1);
    c->awaited = NULL;
    c->answered = true;
}

static void refuse(struct client *c, const struct request *r, char *error)
{
    say(c, FRAME_ERR, "%s: %s\n", r->command, error);
    note(c->service, "%s: %s refused: %s", c->owner, r->command, error);
    free(error);
    end(c, 1);
}

/* Sends the output of the awaited program to the client: as much as the client takes, or all. */
static void pump(struct client *c, bool all)
{
    struct evbuffer *out = bufferevent_get_output(c->link);
    char bytes[1 << 14];
    ssize_t n = 0;
    while ((all || evbuffer_get_length(out) < WRITE_AHEAD) &&
           (n = job_read(c->awaited, c->at, bytes, sizeof bytes)) > 0) {
        evbuffer_add(out, bytes, (size_t)n);
        c->at += n;
    }
    if (!all && n <= 0 && job_has_ended(c->awaited) && job_read(c->awaited, c->at, bytes, 1) <= 0)
        end(c, job_status(c->awaited));
}

/* --- programs --- */

static struct cube_entry *cube_of(struct service *s, const struct job *j)
{
    for (int i = 0; i < CUBES_MOST; i++)
        if (s->cubes.list[i].job == j)
            return &s->cubes.list[i];
    return NULL;
}

static void on_line(void *ctx, struct job *j, const char *line)
{
    struct cube_entry *e = cube_of(ctx, j);
    if (e)
        note(ctx, "[%s] %s", e->name, line);
}

static void on_output(void *ctx, struct job *j)
{
    struct service *s = ctx;
    struct cube_entry *e = cube_of(s, j);
    if (e && job_has_ended(j))
        note(s, "%s: %s ended with %d", e->name, e->program, job_status(j));
    for (struct client *c = s->clients; c; c = c->next)
        if (c->awaited == j)
            pump(c, false);
}

static void kill_job(struct service *s, struct cube_entry *e)
{
    int status;
    if (!e->job || !job_pid(e->job))
        return;
    note(s, "%s: %s is killed", e->name, e->program);
    job_kill(e->job);
    if (waitpid(job_pid(e->job), &status, 0) > 0)
        job_reaped(e->job, status);
}

/* Ends the job of a cube, if there is one, and the answers to the clients that wait for it. */
static void drop_job(struct service *s, struct cube_entry *e)
{
    if (!e->job)
        return;
    kill_job(s, e);
    for (struct client *c = s->clients; c; c = c->next)
        if (c->awaited == e->job) {
            pump(c, true);
            end(c, job_status(e->job));
        }
    job_free(e->job);
    free(e->program);
    e->job = NULL, e->program = NULL;
}

static void on_child(evutil_socket_t signal, short what, void *arg)
{
    struct service *s = arg;
    int status;
    (void)signal, (void)what;
    for (int i = 0; i < CUBES_MOST; i++) {
        struct job *j = s->cubes.list[i].job;
        if (j && job_pid(j) && waitpid(job_pid(j), &status, WNOHANG) > 0)
            job_reaped(j, status);
    }
}

/* The command that runs the user's program on a cube, ended by NULL; its first *own words are malloc'd. */
static char **command_of(const struct service *s, const struct cube_entry *e, const struct request *r,
                         int *own)
{
    char **argv = xcalloc((size_t)r->argc + 12, sizeof *argv);
    char number[2][64];
    int n = 0;
    snprintf(number[0], sizeof number[0], "%u", e->piece.nodes);
    const char *first[] = {s->options.runner, "run", "-m", s->options.machine_path, "-n", number[0]};
    for (size_t i = 0; i < sizeof first / sizeof *first; i++)
        argv[n++] = xstrdup(first[i]);
    for (int side = 0; side < 2 && !s->cubes.allocation.cube; side++) {
        snprintf(number[1], sizeof number[1], "--set=topology.%s=%u", side ? "columns" : "rows",
                 side ? e->piece.columns : e->piece.rows);
        argv[n++] = xstrdup(number[1]);
    }
    *own = n;
    memcpy(argv + n, r->argv, (size_t)r->argc * sizeof *argv);
    return argv;
}

static void start_job(struct client *c, const struct request *r, struct cube_entry *e)
{
    struct service *s = c->service;
    const struct job_events events = {s, on_line, on_output};
    char *error, *words = xstrdup(r->argv[0]);
    int own;
    for (int i = 1; i < r->argc; i++) {
        char *more = xasprintf("%s %s", words, r->argv[i]);
        free(words);
        words = more;
    }
    char **argv = command_of(s, e, r, &own);
    drop_job(s, e);
    e->job = job_start(s->base, argv, r->folder, &events, &error);
    for (int i = 0; i < own; i++)
        free(argv[i]);
    free(argv);
    if (!e->job) {
        free(words);
        refuse(c, r, error);
        return;
    }
    e->program = words;
    note(s, "%s loads %s on %s, process %d", c->owner, words, e->name, (int)job_pid(e->job));
    end(c, 0);
}

/* --- requests --- */

static struct cube_entry *find(struct client *c, const struct request *r)
{
    char *error;
    struct cube_entry *e = cubes_find(&c->service->cubes, r->cube, r->session, &error);
    if (!e)
        refuse(c, r, error);
    return e;
}

static void getcube(struct client *c, const struct request *r)
{
    struct service *s = c->service;
    char *error, nodes[80];
    struct cube_entry *e =
        cubes_get(&s->cubes, *r->cube ? r->cube : "default", r->type, c->owner, r->session, &error);
    if (!e) {
        refuse(c, r, error);
        return;
    }
    say(c, FRAME_OUT, "%s: %s of %s\n", e->name, cubes_nodes(&s->cubes, e, nodes, sizeof nodes),
        s->cubes.machine->name);
    note(s, "%s gets %s: %s", c->owner, e->name, nodes);
    end(c, 0);
}

static void cubeinfo(struct client *c, const struct request *r)
{
    char *text;
    size_t size;
    FILE *f = xchecked(open_memstream(&text, &size));
    if (r->argc && !strcmp(r->argv[0], "json")) {
        json_t *all = cubes_json(&c->service->cubes, r->session);
        json_dumpf(all, f, JSON_INDENT(1));
        fputc('\n', f);
        json_decref(all);
    } else {
        cubes_print(&c->service->cubes, r->session, f);
    }
    fclose(f);
    say(c, FRAME_OUT, "%s", text);
    free(text);
    end(c, 0);
}

static void attachcube(struct client *c, const struct request *r)
{
    struct cube_entry *e = find(c, r);
    if (!e)
        return;
    cubes_attach(&c->service->cubes, e, r->session);
    end(c, 0);
}

static void load(struct client *c, const struct request *r)
{
    struct cube_entry *e = find(c, r);
    if (!e)
        return;
    if (e->job && job_pid(e->job)) {
        refuse(c, r,
               xasprintf("%s runs %s: waitcube waits for its end, killcube ends it", e->name, e->program));
    } else if (r->argc == 0) {
        refuse(c, r, xstrdup("which program?"));
    } else {
        start_job(c, r, e);
    }
}

static void waitcube(struct client *c, const struct request *r)
{
    struct cube_entry *e = find(c, r);
    if (!e)
        return;
    if (!e->job) {
        refuse(c, r, xasprintf("nothing has been loaded on %s", e->name));
        return;
    }
    c->awaited = e->job;
    pump(c, false);
}

static void killcube(struct client *c, const struct request *r)
{
    struct cube_entry *e = find(c, r);
    if (!e)
        return;
    kill_job(c->service, e);
    end(c, 0);
}

static void relcube(struct client *c, const struct request *r)
{
    struct service *s = c->service;
    struct cube_entry *e = find(c, r);
    if (!e)
        return;
    drop_job(s, e);
    note(s, "%s gives back %s", c->owner, e->name);
    cubes_release(&s->cubes, e);
    end(c, 0);
}

static void serve(struct client *c, const struct request *r)
{
    static const struct {
        const char *name;
        void (*serve)(struct client *, const struct request *);
    } COMMANDS[] = {{"getcube", getcube}, {"cubeinfo", cubeinfo}, {"attachcube", attachcube},
                    {"load", load},       {"waitcube", waitcube}, {"killcube", killcube},
                    {"relcube", relcube}};
    for (size_t i = 0; i < sizeof COMMANDS / sizeof *COMMANDS; i++)
        if (!strcmp(r->command, COMMANDS[i].name)) {
            COMMANDS[i].serve(c, r);
            return;
        }
    refuse(c, r, xstrdup("the service does not know this command: is it of another version?"));
}

/* --- clients --- */

static void on_request(struct bufferevent *b, void *arg)
{
    struct client *c = arg;
    enum frame_kind kind;
    char *bytes;
    uint32_t length;
    struct request r;
    if (c->answered || c->awaited)
        return; /* one request a client; the rest is ignored */
    int taken = frame_take(bufferevent_get_input(b), &kind, &bytes, &length);
    if (taken == 0)
        return;
    if (taken < 0 || kind != FRAME_REQUEST) {
        client_free(c);
        return;
    }
    if (request_read(&r, bytes, length)) {
        serve(c, &r);
        free(r.argv);
        free(bytes);
    } else {
        free(bytes);
        client_free(c);
    }
}

static void on_written(struct bufferevent *b, void *arg)
{
    struct client *c = arg;
    (void)b;
    if (c->awaited)
        pump(c, false);
    else if (c->answered)
        client_free(c);
}

static void on_gone(struct bufferevent *b, short what, void *arg)
{
    (void)b, (void)what;
    client_free(arg);
}

/* Is the client the service's own user, or root? Writes the user's name. */
static bool is_allowed(evutil_socket_t fd, char owner[CUBE_TEXT])
{
    struct ucred who;
    socklen_t size = sizeof who;
    if (getsockopt(fd, SOL_SOCKET, SO_PEERCRED, &who, &size) || (who.uid != getuid() && who.uid != 0))
        return false;
    const struct passwd *p = getpwuid(who.uid);
    if (p)
        snprintf(owner, CUBE_TEXT, "%s", p->pw_name);
    else
        snprintf(owner, CUBE_TEXT, "%u", (unsigned)who.uid);
    return true;
}

static void on_client(struct evconnlistener *listener, evutil_socket_t fd, struct sockaddr *from, int size,
                      void *arg)
{
    struct service *s = arg;
    char owner[CUBE_TEXT];
    (void)listener, (void)from, (void)size;
    if (!is_allowed(fd, owner)) {
        close(fd);
        return;
    }
    struct client *c = xcalloc(1, sizeof *c);
    *c = (struct client){.service = s, .next = s->clients, .where = &s->clients};
    memcpy(c->owner, owner, sizeof owner);
    c->link = xchecked(bufferevent_socket_new(s->base, fd, BEV_OPT_CLOSE_ON_FREE));
    if (c->next)
        c->next->where = &c->next;
    s->clients = c;
    bufferevent_setcb(c->link, on_request, on_written, on_gone, c);
    bufferevent_setwatermark(c->link, EV_READ, 0, FRAME_HEAD + FRAME_MOST);
    bufferevent_enable(c->link, EV_READ | EV_WRITE);
}

/* --- start and end --- */

static void on_stop(evutil_socket_t signal, short what, void *arg)
{
    struct service *s = arg;
    (void)what;
    note(s, "stopped by SIG%s", sigabbrev_np((int)signal));
    event_base_loopbreak(s->base);
}

static void close_all(struct service *s)
{
    while (s->clients)
        client_free(s->clients);
    for (int i = 0; i < CUBES_MOST; i++)
        if (s->cubes.list[i].used) {
            drop_job(s, &s->cubes.list[i]);
            cubes_release(&s->cubes, &s->cubes.list[i]);
        }
    cubes_close(&s->cubes);
}

void service_run(const struct service_options *options)
{
    struct service s = {.options = *options, .base = xchecked(event_base_new())};
    signal(SIGPIPE, SIG_IGN);
    cubes_open(&s.cubes, options->machine);
    struct evconnlistener *listener = xchecked(evconnlistener_new(
        s.base, on_client, &s, LEV_OPT_CLOSE_ON_FREE | LEV_OPT_CLOSE_ON_EXEC, 0, options->socket));
    struct event *events[] = {
        evsignal_new(s.base, SIGCHLD, on_child, &s), evsignal_new(s.base, SIGINT, on_stop, &s),
        evsignal_new(s.base, SIGTERM, on_stop, &s), evsignal_new(s.base, SIGHUP, on_stop, &s)};
    enum { EVENTS = sizeof events / sizeof *events };
    for (int i = 0; i < EVENTS; i++)
        if (event_add(xchecked(events[i]), NULL))
            xexhausted();
    note(&s, "%s, %u nodes: ready", options->machine->name, allocation_all(&s.cubes.allocation));
    event_base_dispatch(s.base);
    close_all(&s);
    for (int i = 0; i < EVENTS; i++)
        event_free(events[i]);
    evconnlistener_free(listener);
    event_base_free(s.base);
}
