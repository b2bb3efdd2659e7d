/* job.c - see job.h. */
#include "srm/job.h"
#include <errno.h>
#include <event2/buffer.h>
#include <event2/bufferevent.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include "kernel/xalloc.h"
#include "srm/frame.h"

struct stream {
    struct job *job;
    enum frame_kind kind;
    struct bufferevent *from; /* NULL: all has been read */
    struct evbuffer *line;    /* the beginning of a line that has not ended */
};

struct job {
    struct job_events events;
    pid_t pid; /* 0: reaped */
    int spool; /* a file with its output */
    off_t size;
    struct stream stream[2];
    int status;
    time_t since;
};

/* --- its output --- */

/* The next line, or the beginning of one that is too long; if nothing more comes (all), what is left. NULL:
 * there is none yet. */
static char *next_line(struct evbuffer *b, bool all)
{
    enum { LONGEST = 4096 };
    char *line = evbuffer_readln(b, NULL, EVBUFFER_EOL_LF);
    size_t left = evbuffer_get_length(b);
    if (line || left == 0 || (left < LONGEST && !all))
        return line;
    left = left < LONGEST ? left : LONGEST;
    line = xcalloc(left + 1, 1);
    evbuffer_remove(b, line, left);
    return line;
}

static void tell_lines(struct stream *s, bool all)
{
    for (char *line; (line = next_line(s->line, all)); free(line))
        s->job->events.said(s->job->events.ctx, s->job, line);
}

/* A frame that does not fit on the disk is lost as a whole. */
static void keep(struct stream *s, unsigned char *frame, size_t length)
{
    struct job *j = s->job;
    frame_head(frame, s->kind, (uint32_t)(length - FRAME_HEAD));
    if (pwrite(j->spool, frame, length, j->size) == (ssize_t)length)
        j->size += (off_t)length;
}

static void on_data(struct bufferevent *b, void *arg)
{
    struct stream *s = arg;
    unsigned char frame[1 << 14];
    size_t n;
    while ((n = bufferevent_read(b, frame + FRAME_HEAD, sizeof frame - FRAME_HEAD)) > 0) {
        keep(s, frame, FRAME_HEAD + n);
        evbuffer_add(s->line, frame + FRAME_HEAD, n);
    }
    tell_lines(s, false);
    s->job->events.grown(s->job->events.ctx, s->job);
}

static void tell_if_ended(struct job *j)
{
    if (job_has_ended(j))
        j->events.grown(j->events.ctx, j);
}

static void on_end(struct bufferevent *b, short what, void *arg)
{
    struct stream *s = arg;
    (void)what;
    bufferevent_free(b);
    s->from = NULL;
    tell_lines(s, true);
    tell_if_ended(s->job);
}

static void open_stream(struct stream *s, struct job *j, struct event_base *base, int fd,
                        enum frame_kind kind)
{
    evutil_make_socket_nonblocking(fd);
    struct bufferevent *from = xchecked(bufferevent_socket_new(base, fd, BEV_OPT_CLOSE_ON_FREE));
    *s = (struct stream){j, kind, from, xchecked(evbuffer_new())};
    bufferevent_setcb(s->from, on_data, NULL, on_end, s);
    bufferevent_enable(s->from, EV_READ);
}

/* --- start and end --- */

/* In the child, between fork and exec. */
static void become(char *const argv[], const char *folder, int out, int err, pid_t parent)
{
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    for (int s = 1; s < NSIG; s++)
        signal(s, SIG_DFL);
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    int in = open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (getppid() != parent || in < 0 || dup2(in, 0) < 0 || dup2(out, 1) < 0 || dup2(err, 2) < 0)
        _exit(127);
    if (chdir(folder))
        dprintf(2, "%s cannot be entered: %s\n", folder, strerror(errno));
    else if (execv(argv[0], argv))
        dprintf(2, "%s cannot be run: %s\n", argv[0], strerror(errno));
    _exit(127);
}

/* A file without a name, on disk if possible. */
static int open_spool(void)
{
    const char *folder = getenv("TMPDIR");
    int fd = open(folder && *folder ? folder : "/tmp", O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    return fd >= 0 ? fd : memfd_create("output", MFD_CLOEXEC);
}

struct job *job_start(struct event_base *base, char *const argv[], const char *folder,
                      const struct job_events *events, char **error)
{
    int out[2] = {-1, -1}, err[2] = {-1, -1}, spool = open_spool();
    pid_t self = getpid(), pid = -1;
    if (spool >= 0 && pipe2(out, O_CLOEXEC) == 0 && pipe2(err, O_CLOEXEC) == 0 && (pid = fork()) == 0)
        become(argv, folder, out[1], err[1], self);
    int why = errno;
    close(out[1]);
    close(err[1]);
    if (pid < 0) {
        close(out[0]);
        close(err[0]);
        close(spool);
        *error = xasprintf("a process cannot be started: %s", strerror(why));
        return NULL;
    }
    setpgid(pid, pid); /* parent and child both do so: either may be first */
    struct job *j = xcalloc(1, sizeof *j);
    *j = (struct job){.events = *events, .pid = pid, .spool = spool, .since = time(NULL)};
    open_stream(&j->stream[0], j, base, out[0], FRAME_OUT);
    open_stream(&j->stream[1], j, base, err[0], FRAME_ERR);
    return j;
}

void job_kill(struct job *j)
{
    if (j->pid)
        kill(-j->pid, SIGKILL);
}

void job_free(struct job *j)
{
    if (!j)
        return;
    job_kill(j);
    if (j->pid)
        waitpid(j->pid, NULL, 0);
    for (int i = 0; i < 2; i++) {
        if (j->stream[i].from)
            bufferevent_free(j->stream[i].from);
        evbuffer_free(j->stream[i].line);
    }
    close(j->spool);
    free(j);
}

pid_t job_pid(const struct job *j)
{
    return j->pid;
}

void job_reaped(struct job *j, int status)
{
    j->pid = 0;
    j->status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    tell_if_ended(j);
}

bool job_has_ended(const struct job *j)
{
    return !j->pid && !j->stream[0].from && !j->stream[1].from;
}

int job_status(const struct job *j)
{
    return j->status;
}

time_t job_since(const struct job *j)
{
    return j->since;
}

ssize_t job_read(const struct job *j, off_t at, void *buf, size_t room)
{
    return pread(j->spool, buf, room, at);
}
