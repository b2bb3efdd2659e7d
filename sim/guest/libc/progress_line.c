/* progress_line.c - see progress_line.h. */
#include "guest/libc/progress_line.h"

void progress_line_show(struct progress_line *p, const char *text)
{
    if (p->unfinished)
        return;
    int before = p->shown;
    p->shown = fprintf(p->f, "\r%.79s", text) - 1;
    if (before > p->shown)
        fprintf(p->f, "%*s", before - p->shown, "");
    fflush(p->f);
    p->shown = before > p->shown ? before : p->shown;
}

void progress_line_clear(struct progress_line *p)
{
    if (!p->shown)
        return;
    fprintf(p->f, "\r%*s\r", p->shown, "");
    fflush(p->f);
    p->shown = 0;
}

void progress_line_make_way(struct progress_line *p, const char *bytes, size_t count)
{
    progress_line_clear(p);
    p->unfinished = bytes[count - 1] != '\n';
}
