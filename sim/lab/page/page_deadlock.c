/* page_deadlock.c - see page_deadlock.h. */
#include "lab/page/page_deadlock.h"
#include <stdio.h>
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lab/deadlock/deadlock_draw.h"
#include "lab/deadlock/deadlock_read.h"

static char *text_of(const struct waitfor *w)
{
    char *text;
    size_t size;
    FILE *f = xchecked(open_memstream(&text, &size));
    waitfor_write_text(w, f);
    fclose(f);
    return text;
}

json_t *page_deadlock_make(const json_t *j)
{
    struct waitfor *w = deadlock_of_json(j);
    if (!w)
        return NULL;
    char *text = text_of(w), *svg = deadlock_draw_svg(w);
    json_t *data = xchecked(
        json_pack("{s:s, s:s, s:O?}", "report", text, "svg", svg, "program", json_object_get(j, "program")));
    free(text);
    free(svg);
    waitfor_free(w);
    return data;
}
