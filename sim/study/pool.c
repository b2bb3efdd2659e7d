/* pool.c - a pool of child processes on libevent; see pool.h. */
#include "study/pool.h"
#include "study/text.h"

#include <errno.h>
#include <event2/buffer.h>
#include <event2/bufferevent.h>
#include <event2/event.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* One of a child's two outputs: our end of its pipe, and what is kept of what came. */
struct stream {
    struct bufferevent *from;
    struct evbuffer *kept;
    size_t max;
    bool end_matters; /* keep the end, not the beginning, when there is more */
};

struct child {
    struct pool_job *job;
    pid_t pid; /* 0: this place is free */
    struct stream out, err;
    double started_s;
};

struct pool {
    struct event_base *base;
    struct pool_job **order; /* all jobs, longest first */
    size_t next;             /* the first of them not started */
    struct child *children;  /* at_once places */
    unsigned at_once;
    double begun_s, weight_done, weight_all;
    const struct pool_watcher *watcher;
    struct pool_status status;
    bool stopped;
};

static double now_s(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void tell(struct pool *p, const struct pool_job *finished)
{
    struct pool_status *s = &p->status;
    s->elapsed_s = now_s() - p->begun_s;
    double left = p->weight_all - p->weight_done;
    s->left_s = p->weight_done > 0 && left > 0 ? s->elapsed_s * left / p->weight_done : left > 0 ? -1 : 0;
    s->finished = finished;
    if (p->watcher)
        p->watcher->changed(p->watcher->arg, s);
}

/* --- a child's output --- */

/* Moves what has come in to what is kept: of standard output the beginning, of standard error the end. */
static void keep(struct stream *s, struct evbuffer *in)
{
    size_t size = evbuffer_get_length(s->kept);
    if (s->end_matters) {
        evbuffer_add_buffer(s->kept, in);
        size = evbuffer_get_length(s->kept);
        if (size > s->max)
            evbuffer_drain(s->kept, size - s->max);
    } else {
        evbuffer_remove_buffer(in, s->kept, s->max - size);
        evbuffer_drain(in, evbuffer_get_length(in));
    }
}

static void on_data(struct bufferevent *b, void *arg)
{
    keep(arg, bufferevent_get_input(b));
}

static void open_stream(struct stream *s, struct event_base *base, int fd, size_t max, bool end_matters)
{
    evutil_make_socket_nonblocking(fd);
    *s = (struct stream){bufferevent_socket_new(base, fd, BEV_OPT_CLOSE_ON_FREE), evbuffer_new(), max,
                         end_matters};
    if (!s->from || !s->kept)
        abort();
    bufferevent_setcb(s->from, on_data, NULL, NULL, s);
    bufferevent_enable(s->from, EV_READ);
}

/* Takes what is left in the pipe, without waiting for its end: a grandchild may hold it open. Malloc'd text. */
static char *close_stream(struct stream *s)
{
    struct evbuffer *rest = evbuffer_new();
    bufferevent_disable(s->from, EV_READ);
    keep(s, bufferevent_get_input(s->from));
    while (rest && evbuffer_read(rest, bufferevent_getfd(s->from), -1) > 0)
        keep(s, rest);
    size_t size = evbuffer_get_length(s->kept);
    char *text = malloc(size + 1);
    if (!rest || !text)
        abort();
    evbuffer_remove(s->kept, text, size);
    text[size] = '\0';
    evbuffer_free(rest);
    evbuffer_free(s->kept);
    bufferevent_free(s->from);
    return text;
}

/* --- a child's life --- */

/* In the child, between fork and exec. */
static void become(char *const argv[], int out, int err, pid_t parent)
{
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) /* it died before the line above */
        _exit(127);
    int in = open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (in < 0 || dup2(in, 0) < 0 || dup2(out, 1) < 0 || dup2(err, 2) < 0)
        _exit(127);
    execvp(argv[0], argv);
    dprintf(2, "%s cannot be run: %s\n", argv[0], strerror(errno));
    _exit(127);
}

static void settle(struct pool *p, struct pool_job *job, char *error)
{
    job->state = error ? POOL_FAILED : POOL_DONE;
    job->error = error;
    p->weight_done += job->weight;
    (*(error ? &p->status.failed : &p->status.done))++;
}

static void start(struct pool *p, struct child *c, struct pool_job *job)
{
    int out[2] = {-1, -1}, err[2] = {-1, -1};
    pid_t self = getpid(), pid = -1;
    if (pipe2(out, O_CLOEXEC) == 0 && pipe2(err, O_CLOEXEC) == 0 && (pid = fork()) == 0)
        become(job->argv, out[1], err[1], self);
    if (pid < 0) {
        char *error = text_of("cannot be started: %m");
        for (int i = 0; i < 2; i++) {
            close(out[i]);
            close(err[i]);
        }
        settle(p, job, error);
        tell(p, job);
        return;
    }
    close(out[1]);
    close(err[1]);
    job->state = POOL_RUNNING;
    *c = (struct child){.job = job, .pid = pid, .started_s = now_s()};
    open_stream(&c->out, p->base, out[0], POOL_MAX_OUT, false);
    open_stream(&c->err, p->base, err[0], POOL_MAX_ERR, true);
    p->status.running++;
}

/* How it ended and its last words; NULL when it ended well. */
static char *describe_end(int status, const char *err)
{
    int size = (int)strlen(err);
    while (size > 0 && err[size - 1] == '\n')
        size--;
    const char *sep = size ? ": " : "";
    if (WIFSIGNALED(status))
        return text_of("killed by signal %d (%s)%s%.*s", WTERMSIG(status), strsignal(WTERMSIG(status)), sep,
                       size, err);
    if (WEXITSTATUS(status) != 0)
        return text_of("exit status %d%s%.*s", WEXITSTATUS(status), sep, size, err);
    return NULL;
}

static void fill(struct pool *p)
{
    for (unsigned i = 0; i < p->at_once; i++)
        while (!p->stopped && !p->children[i].pid && p->next < p->status.jobs)
            start(p, &p->children[i], p->order[p->next++]);
}

static void on_child(evutil_socket_t signal, short what, void *arg)
{
    struct pool *p = arg;
    int status;
    (void)signal, (void)what;
    /* Each by its own number: other children of this process are not ours to reap. */
    for (unsigned i = 0; i < p->at_once; i++) {
        struct child *c = &p->children[i];
        if (!c->pid || waitpid(c->pid, &status, WNOHANG) != c->pid)
            continue;
        struct pool_job *job = c->job;
        job->out = close_stream(&c->out);
        char *err = close_stream(&c->err);
        job->wall_time_s = now_s() - c->started_s;
        c->pid = 0;
        p->status.running--;
        settle(p, job, p->stopped ? text_of("stopped") : describe_end(status, err));
        free(err);
        fill(p);
        tell(p, job);
    }
}

static void on_second(evutil_socket_t fd, short what, void *arg)
{
    (void)fd, (void)what;
    tell(arg, NULL);
}

static void on_stop(evutil_socket_t signal, short what, void *arg)
{
    struct pool *p = arg;
    (void)signal, (void)what;
    p->stopped = true;
    for (unsigned i = 0; i < p->at_once; i++)
        if (p->children[i].pid)
            kill(p->children[i].pid, SIGKILL);
}

/* --- the pool --- */

static int longer_first(const void *a, const void *b)
{
    const struct pool_job *x = *(struct pool_job *const *)a, *y = *(struct pool_job *const *)b;
    if (x->weight != y->weight)
        return x->weight < y->weight ? 1 : -1;
    return x < y ? -1 : x > y; /* equal ones in the caller's order */
}

static void loop(struct pool *p)
{
    static const struct timeval second = {1, 0};
    struct event *events[] = {
        evsignal_new(p->base, SIGCHLD, on_child, p),
        evsignal_new(p->base, SIGINT, on_stop, p),
        evsignal_new(p->base, SIGTERM, on_stop, p),
        event_new(p->base, -1, EV_PERSIST, on_second, p),
    };
    enum { EVENTS = sizeof events / sizeof *events };
    for (int i = 0; i < EVENTS; i++)
        if (!events[i] || event_add(events[i], i == EVENTS - 1 ? &second : NULL) != 0)
            abort();
    fill(p);
    while (p->status.running > 0)
        event_base_loop(p->base, EVLOOP_ONCE);
    for (int i = 0; i < EVENTS; i++)
        event_free(events[i]);
}

struct pool_end pool_run(struct pool_job jobs[], size_t count, unsigned at_once,
                         const struct pool_watcher *watcher)
{
    struct pool p = {.at_once = at_once, .begun_s = now_s(), .watcher = watcher, .status.jobs = count};
    p.base = event_base_new();
    p.order = calloc(count + 1, sizeof *p.order);
    p.children = calloc(at_once, sizeof *p.children);
    if (!p.base || !p.order || !p.children)
        abort();
    for (size_t i = 0; i < count; i++) {
        p.order[i] = &jobs[i];
        p.weight_all += jobs[i].weight;
        jobs[i].state = POOL_WAITING;
        jobs[i].out = jobs[i].error = NULL;
    }
    qsort(p.order, count, sizeof *p.order, longer_first);

    loop(&p);

    free(p.children);
    free(p.order);
    event_base_free(p.base);
    return (struct pool_end){p.status.done == count, p.stopped, now_s() - p.begun_s};
}

void pool_clear(struct pool_job jobs[], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        free(jobs[i].out);
        free(jobs[i].error);
        jobs[i].out = jobs[i].error = NULL;
    }
}
