/* process_pool.c - a pool of child processes on libevent; see process_pool.h. */
#include "lab/jobs/process_pool.h"
#include "files/virtual_time.h"
#include "kernel/hostclock.h"
#include "kernel/xalloc.h"

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
#include <unistd.h>

/* One of a child's two outputs: the parent's end of the pipe, and the part of the output that is kept. */
struct stream {
    struct bufferevent *from;
    struct evbuffer *kept;
    size_t max;
    bool end_matters; /* of more than max bytes, keep the last, not the first */
    bool cut;         /* there were more */
};

struct child {
    struct pool_job *job;
    pid_t pid; /* 0: this slot is free */
    struct stream out, err;
    double started_s;
    bool late; /* killed at its time limit */
};

struct pool {
    struct event_base *base;
    const struct pool_source *source;
    struct event *refill;
    struct child *children; /* at_once slots */
    unsigned at_once;
    char threads[24]; /* a child's share of the host's processors, as text */
    size_t running;
    bool no_more; /* the source has no more jobs */
    int stopped;  /* the signal that ended the pool; 0: none */
};

/* --- a child's output --- */

/* Moves input to what is kept: the beginning of standard output, the end of standard error. */
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
        s->cut |= evbuffer_get_length(in) > 0;
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
    *s = (struct stream){xchecked(bufferevent_socket_new(base, fd, BEV_OPT_CLOSE_ON_FREE)),
                         xchecked(evbuffer_new()), max, end_matters, false};
    bufferevent_setcb(s->from, on_data, NULL, NULL, s);
    bufferevent_enable(s->from, EV_READ);
}

/* Returns what was kept, malloc'd. Reads what the pipe still holds but does not wait for its end: a
 * grandchild may keep the pipe open. */
static char *close_stream(struct stream *s)
{
    struct evbuffer *rest = xchecked(evbuffer_new());
    bufferevent_disable(s->from, EV_READ);
    keep(s, bufferevent_get_input(s->from));
    while (evbuffer_read(rest, bufferevent_getfd(s->from), -1) > 0)
        keep(s, rest);
    size_t size = evbuffer_get_length(s->kept);
    char *text = xmalloc(size + 1);
    evbuffer_remove(s->kept, text, size);
    text[size] = '\0';
    evbuffer_free(rest);
    evbuffer_free(s->kept);
    bufferevent_free(s->from);
    return text;
}

/* --- a child's life --- */

/* Signals by which people end the pool. */
static const int ENDING[] = {SIGINT, SIGTERM, SIGHUP};
enum { ENDINGS = sizeof ENDING / sizeof *ENDING };

/* SIGHUP is ignored under nohup, and stays so. */
static bool ends(int signal)
{
    struct sigaction now;
    return signal != SIGHUP || sigaction(signal, NULL, &now) || now.sa_handler != SIG_IGN;
}

/* Runs in the child, between fork and exec. The child gets its own process group: a terminal's Ctrl-C is for
 * the parent to handle. */
static void become(const struct pool_job *job, const char *threads, int out, int err, pid_t parent)
{
    extern char **environ;
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    for (int i = 0; i < ENDINGS; i++)
        if (ends(ENDING[i]))
            signal(ENDING[i], SIG_DFL);
    signal(SIGPIPE, SIG_DFL);
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setenv("TOUCHSTONE_WORKERS", threads, 0);
    if (getppid() != parent) /* the parent died before prctl() */
        _exit(127);
    int in = open(job->in ? job->in : "/dev/null", O_RDONLY | O_CLOEXEC);
    if (in < 0 || dup2(in, 0) < 0 || dup2(out, 1) < 0 || dup2(err, 2) < 0) {
        dprintf(err, "its input cannot be read: %s\n", strerror(errno));
        _exit(127);
    }
    if (job->dir && chdir(job->dir) != 0) {
        dprintf(2, "%s: %s\n", job->dir, strerror(errno));
        _exit(127);
    }
    execvpe(job->argv[0], job->argv, job->env ? job->env : environ);
    dprintf(2, "%s cannot be run: %s\n", job->argv[0], strerror(errno));
    _exit(127);
}

static void finish(struct pool *p, struct pool_job *job, char *error)
{
    job->state = error ? POOL_FAILED : POOL_DONE;
    job->error = error;
    p->source->ended(p->source->arg, job);
}

static void start(struct pool *p, struct child *c, struct pool_job *job)
{
    int out[2] = {-1, -1}, err[2] = {-1, -1};
    pid_t self = getpid(), pid = -1;
    if (pipe2(out, O_CLOEXEC) == 0 && pipe2(err, O_CLOEXEC) == 0 && (pid = fork()) == 0)
        become(job, p->threads, out[1], err[1], self);
    if (pid < 0) {
        char *error = xasprintf("cannot be started: %m");
        for (int i = 0; i < 2; i++) {
            close(out[i]);
            close(err[i]);
        }
        finish(p, job, error);
        return;
    }
    setpgid(pid, pid); /* the child does so, too: one of the two is first */
    close(out[1]);
    close(err[1]);
    job->state = POOL_RUNNING;
    *c = (struct child){.job = job, .pid = pid, .started_s = hostclock_s()};
    open_stream(&c->out, p->base, out[0], POOL_MAX_OUT, false);
    open_stream(&c->err, p->base, err[0], POOL_MAX_ERR, true);
    p->running++;
}

/* How the child ended, and the end of its standard error; NULL if the child succeeded. */
static char *describe_end(const struct child *c, int status, const char *err)
{
    int size = (int)strlen(err);
    while (size > 0 && err[size - 1] == '\n')
        size--;
    const char *sep = size ? ": " : "";
    if (c->late)
        return xasprintf("killed after its limit of %s of real time%s%.*s", limit_text(c->job->limit_s).text,
                         sep, size, err);
    if (WIFSIGNALED(status))
        return xasprintf("killed by signal %d (%s)%s%.*s", WTERMSIG(status), strsignal(WTERMSIG(status)), sep,
                         size, err);
    if (WEXITSTATUS(status) != 0)
        return xasprintf("exit status %d%s%.*s", WEXITSTATUS(status), sep, size, err);
    return NULL;
}

static void fill_in(struct pool *p, double s)
{
    struct timeval after = {(time_t)s, (suseconds_t)(1e6 * (s - (double)(time_t)s))};
    event_add(p->refill, &after);
}

static struct child *free_slot(struct pool *p)
{
    for (unsigned i = 0; i < p->at_once; i++)
        if (!p->children[i].pid)
            return &p->children[i];
    return NULL;
}

static void fill(struct pool *p)
{
    for (struct child *c; !p->stopped && !p->no_more && (c = free_slot(p));) {
        struct pool_job *job = NULL;
        enum pool_next next = p->source->next(p->source->arg, &job);
        if (next == POOL_JOB) {
            start(p, c, job);
        } else if (next == POOL_NO_MORE) {
            p->no_more = true;
        } else {
            fill_in(p, next == POOL_AGAIN ? 0 : 0.1);
            return;
        }
    }
}

/* Such signals come from people: the child was stopped, its run did not fail. */
static bool by_hand(int status)
{
    for (int i = 0; i < ENDINGS; i++)
        if (WIFSIGNALED(status) && WTERMSIG(status) == ENDING[i])
            return true;
    return false;
}

static void end_child(struct pool *p, struct child *c, int status)
{
    struct pool_job *job = c->job;
    job->out = close_stream(&c->out);
    job->cut = c->out.cut;
    job->err = close_stream(&c->err);
    job->wall_time_s = hostclock_s() - c->started_s;
    char *error = describe_end(c, status, job->err);
    job->stopped = error && (p->stopped || by_hand(status));
    c->pid = 0;
    p->running--;
    finish(p, job, error);
}

static void on_child(evutil_socket_t signal, short what, void *arg)
{
    struct pool *p = arg;
    int status;
    (void)signal, (void)what;
    /* One process id at a time: the pool must not reap other children of this process. */
    for (unsigned i = 0; i < p->at_once; i++)
        if (p->children[i].pid && waitpid(p->children[i].pid, &status, WNOHANG) == p->children[i].pid)
            end_child(p, &p->children[i], status);
    fill(p);
}

static void on_refill(evutil_socket_t fd, short what, void *arg)
{
    (void)fd, (void)what;
    fill(arg);
}

static void on_second(evutil_socket_t fd, short what, void *arg)
{
    struct pool *p = arg;
    (void)fd, (void)what;
    for (unsigned i = 0; i < p->at_once; i++) {
        struct child *c = &p->children[i];
        if (c->pid && c->job->limit_s > 0 && hostclock_s() - c->started_s > c->job->limit_s)
            c->late = true;
        if (c->pid && (c->late || c->job->stop))
            kill(-c->pid, SIGKILL);
    }
    if (p->source->second)
        p->source->second(p->source->arg);
}

static void on_stop(evutil_socket_t signal, short what, void *arg)
{
    struct pool *p = arg;
    (void)what;
    p->stopped = (int)signal;
    for (unsigned i = 0; i < p->at_once; i++)
        if (p->children[i].pid)
            kill(-p->children[i].pid, SIGKILL);
}

/* --- the pool --- */

static void loop(struct pool *p)
{
    static const struct timeval second = {1, 0};
    struct event *events[] = {
        event_new(p->base, -1, EV_PERSIST, on_second, p), evsignal_new(p->base, SIGCHLD, on_child, p),
        evsignal_new(p->base, SIGINT, on_stop, p),        evsignal_new(p->base, SIGTERM, on_stop, p),
        evsignal_new(p->base, SIGHUP, on_stop, p),
    };
    enum { EVENTS = sizeof events / sizeof *events };
    int used = ends(SIGHUP) ? EVENTS : EVENTS - 1;
    p->refill = event_new(p->base, -1, 0, on_refill, p);
    for (int i = 0; i < used; i++)
        if (!p->refill || !events[i] || event_add(events[i], i == 0 ? &second : NULL) != 0)
            xexhausted();
    p->no_more = p->source->began && !p->source->began(p->source->arg, p->base);
    fill(p);
    while (p->running > 0 || !(p->no_more || p->stopped))
        event_base_loop(p->base, EVLOOP_ONCE);
    if (p->source->ending)
        p->source->ending(p->source->arg);
    for (int i = 0; i < EVENTS; i++)
        event_free(events[i]);
    event_free(p->refill);
}

struct pool_end pool_run_from(const struct pool_source *source, unsigned at_once)
{
    struct pool p = {.source = source, .at_once = at_once};
    double begun_s = hostclock_s();
    p.base = xchecked(event_base_new());
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    snprintf(p.threads, sizeof p.threads, "%ld", processors > at_once ? processors / at_once : 1);
    p.children = xcalloc(at_once, sizeof *p.children);
    loop(&p);
    free(p.children);
    event_base_free(p.base);
    return (struct pool_end){
        .all_done = !p.stopped, .stopped = p.stopped, .wall_time_s = hostclock_s() - begun_s};
}

/* --- a list of jobs --- */

struct list {
    struct pool_job **order; /* longest first */
    size_t next;             /* the first of them not started */
    double begun_s, weight_done, weight_all;
    const struct pool_watcher *watcher;
    struct pool_status status;
};

static void tell(struct list *l, const struct pool_job *finished)
{
    struct pool_status *s = &l->status;
    s->elapsed_s = hostclock_s() - l->begun_s;
    double left = l->weight_all - l->weight_done;
    s->left_s = l->weight_done > 0 && left > 0 ? s->elapsed_s * left / l->weight_done : left > 0 ? -1 : 0;
    s->finished = finished;
    if (l->watcher)
        l->watcher->changed(l->watcher->arg, s);
}

static enum pool_next next_of_list(void *arg, struct pool_job **job)
{
    struct list *l = arg;
    if (l->next == l->status.jobs)
        return POOL_NO_MORE;
    *job = l->order[l->next++];
    l->status.running++;
    return POOL_JOB;
}

static void ended_of_list(void *arg, struct pool_job *job)
{
    struct list *l = arg;
    l->weight_done += job->weight;
    l->status.running--;
    (*(job->state == POOL_FAILED ? &l->status.failed : &l->status.done))++;
    tell(l, job);
}

static void second_of_list(void *arg)
{
    tell(arg, NULL);
}

static int longer_first(const void *a, const void *b)
{
    const struct pool_job *x = *(struct pool_job *const *)a, *y = *(struct pool_job *const *)b;
    if (x->turn != y->turn)
        return x->turn < y->turn ? -1 : 1;
    if (x->weight != y->weight)
        return x->weight < y->weight ? 1 : -1;
    return x < y ? -1 : x > y; /* jobs of equal weight in the caller's order */
}

struct pool_end pool_run(struct pool_job jobs[], size_t count, unsigned at_once,
                         const struct pool_watcher *watcher)
{
    struct list l = {.begun_s = hostclock_s(), .watcher = watcher, .status.jobs = count};
    struct pool_source source = {
        .next = next_of_list, .ended = ended_of_list, .second = second_of_list, .arg = &l};
    l.order = xcalloc(count + 1, sizeof *l.order);
    for (size_t i = 0; i < count; i++) {
        l.order[i] = &jobs[i];
        l.weight_all += jobs[i].weight;
        jobs[i].state = POOL_WAITING;
        jobs[i].out = jobs[i].err = jobs[i].error = NULL;
    }
    qsort(l.order, count, sizeof *l.order, longer_first);
    struct pool_end end = pool_run_from(&source, count && count < at_once ? (unsigned)count : at_once);
    end.all_done = l.status.done == count;
    free(l.order);
    return end;
}

void pool_clear(struct pool_job jobs[], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        free(jobs[i].out);
        free(jobs[i].err);
        free(jobs[i].error);
        jobs[i].out = jobs[i].err = jobs[i].error = NULL;
    }
}
