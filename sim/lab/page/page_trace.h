/* page_trace.h - a trace as columns of numbers: see data_columns.h. The tables are those of trace_model.h,
 * in its order, with its indexes; the pieces of all nodes stand one behind the other. web/trace_data.js
 * reads them. */
#ifndef LAB_PAGE_PAGE_TRACE_H
#define LAB_PAGE_PAGE_TRACE_H
#include "lab/page/data_blob.h"
#include "lab/trace/trace_model.h"

void page_trace_write(const struct trace *t, struct data_blob *b);
#endif
