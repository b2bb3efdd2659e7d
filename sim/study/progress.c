/* progress.c - how a pool is getting on; see progress.h. */
#include "study/progress.h"

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

static void changed(void *arg, const struct pool_status *s)
{
    struct progress *p = arg;
    const struct pool_job *job = s->finished;
    char left[48];
    time_left(left, sizeof left, s->left_s);
    if (p->live) {
        progress_end(p);
        if (job && job->state == POOL_FAILED)
            fprintf(p->to, "%s: %s\n", job->name, job->error);
        fprintf(p->to, "%zu of %zu done, %zu running, %zu failed%s", s->done, s->jobs, s->running, s->failed,
                left);
    } else if (job && job->state == POOL_FAILED) {
        fprintf(p->to, "[%zu/%zu] %s: %s\n", s->done + s->failed, s->jobs, job->name, job->error);
    } else if (job) {
        fprintf(p->to, "[%zu/%zu] %s: %.1f s%s\n", s->done + s->failed, s->jobs, job->name, job->wall_time_s,
                left);
    }
    fflush(p->to);
}

struct pool_watcher progress_watcher(struct progress *p, FILE *to)
{
    *p = (struct progress){to, isatty(fileno(to)) == 1};
    return (struct pool_watcher){changed, p};
}

void progress_end(struct progress *p)
{
    if (p->live)
        fputs("\r\033[K", p->to);
    fflush(p->to);
}
