/* export_progress.c - see export_progress.h. */
#include "lab/export/export_progress.h"
#include <inttypes.h>
#include <stdbool.h>
#include "kernel/hostclock.h"

struct export_progress export_progress_begin(FILE *to, int32_t nodes)
{
    return (struct export_progress){to, nodes, hostclock_s()};
}

static bool is_due(const struct export_progress *p)
{
    return p->to && hostclock_s() > p->began + 1;
}

void export_progress_show(const struct export_progress *p, int32_t node)
{
    if (is_due(p)) {
        fprintf(p->to, "\r%" PRId32 " of %" PRId32 " nodes written\033[K", node + 1, p->nodes);
        fflush(p->to);
    }
}

void export_progress_rows(const struct export_progress *p, size_t rows, size_t of)
{
    enum { BETWEEN = 4096 };
    if (rows % BETWEEN == 0 && is_due(p)) {
        fprintf(p->to, "\r%zu of %zu rows written\033[K", rows, of);
        fflush(p->to);
    }
}

void export_progress_end(const struct export_progress *p)
{
    if (p->to)
        fputs("\r\033[K", p->to);
}
