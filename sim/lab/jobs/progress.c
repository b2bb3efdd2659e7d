/* progress.c - see progress.h. */
#include "files/virtual_time.h"
#include "lab/jobs/progress.h"

#include <unistd.h>

static void time_left(char *buf, size_t size, double s)
{
    if (s < 0)
        snprintf(buf, size, ", time left not known yet");
    else if (s < 0.5)
        *buf = '\0';
    else if (s < 90)
        snprintf(buf, size, ", about %.0f s left", s);
    else
        snprintf(buf, size, ", about %.0f min left", s / 60);
}

struct progress progress_to(FILE *to)
{
    return (struct progress){to, isatty(fileno(to)) == 1};
}

void progress_show(struct progress *p, const struct progress_counts *c)
{
    char left[48], cached[48] = "";
    if (!p->live)
        return;
    time_left(left, sizeof left, c->left_s);
    if (c->cached)
        snprintf(cached, sizeof cached, ", %zu from the cache", c->cached);
    progress_end(p);
    fprintf(p->to, "%zu of %zu done%s, %zu running, %zu failed%s", c->done, c->all, cached, c->running,
            c->failed, left);
    fflush(p->to);
}

void progress_ended(struct progress *p, const struct progress_counts *c, const char *name, const char *error,
                    double wall_time_s)
{
    char left[48];
    time_left(left, sizeof left, c->left_s);
    progress_end(p);
    if (!p->live)
        fprintf(p->to, "[%zu/%zu] ", c->done + c->failed, c->all);
    if (error)
        fprintf(p->to, "%s: %s\n", name, error);
    else if (!p->live)
        fprintf(p->to, "%s: done in %s%s\n", name, duration_text(wall_time_s).text, left);
    fflush(p->to);
    progress_show(p, c);
}

static void changed(void *arg, const struct pool_status *s)
{
    struct progress *p = arg;
    const struct pool_job *job = s->finished;
    struct progress_counts counts = {s->jobs, s->done, s->running, s->failed, 0, s->left_s};
    if (job && job->stopped)
        return; /* it did not fail; that all was stopped is said once, in the end */
    if (job)
        progress_ended(p, &counts, job->name, job->state == POOL_FAILED ? job->error : NULL,
                       job->wall_time_s);
    else
        progress_show(p, &counts);
}

struct pool_watcher progress_watcher(struct progress *p, FILE *to)
{
    *p = progress_to(to);
    return (struct pool_watcher){changed, p};
}

void progress_end(struct progress *p)
{
    if (p->live)
        fputs("\r\033[K", p->to);
    fflush(p->to);
}
