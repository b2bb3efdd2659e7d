/* page_channels.h - the use of a trace's channels, summed: for the page's channel map. */
#ifndef LAB_PAGE_PAGE_CHANNELS_H
#define LAB_PAGE_PAGE_CHANNELS_H
#include <jansson.h>
#include "lab/page/data_columns.h"
#include "lab/trace/trace_model.h"

/* The trace's time is cut into so many equal bins, in which the map shows the use. */
enum { PAGE_CHANNEL_BINS = 64 };

struct page_channels {
    const struct trace *t;
    vtime *busy;    /* of each channel: a message held it */
    vtime *blocked; /* messages waited for it, in sum */
    uint32_t *uses; /* by how many messages */
    double *bins;   /* of each channel and bin: time in use, ps */
    double bin;     /* length, ps */
};

void page_channels_measure(struct page_channels *c, const struct trace *t);
void page_channels_free(struct page_channels *c);
/* Which channels there are: [{name, from, to}]; from and to are addresses, to null for a port. */
json_t *page_channels_json(const struct page_channels *c);
/* Fills in columns, four of them, and returns how many. */
size_t page_channels_columns(const struct page_channels *c, struct column *columns);
#endif
