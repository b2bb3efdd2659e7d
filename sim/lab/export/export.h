/* export.h - writes a trace in the formats of other tools. Times keep each picosecond.
 *
 *     json   Chrome's trace events, for ui.perfetto.dev and chrome://tracing
 *     paje   Paje, for pajeng, ViTE
 *     otf2   Open Trace Format 2, a folder, for Vampir, otf2-print
 *     picl   PICL's trace file format, for ParaGraph
 *     csv    tables, for a spreadsheet or a program of one's own
 *
 * Memory holds the trace and one node's slices; what of paje and picl must be sorted by time waits in a
 * temporary file (in_order.h). */
#ifndef LAB_EXPORT_EXPORT_H
#define LAB_EXPORT_EXPORT_H
#include <stdbool.h>
#include <stdio.h>
#include "lab/trace/trace_model.h"

enum export_format { EXPORT_JSON, EXPORT_PAJE, EXPORT_OTF2, EXPORT_PICL, EXPORT_CSV, EXPORT_FORMATS };

/* Tables of csv. */
enum export_table {
    EXPORT_PIECES,
    EXPORT_CALLS,
    EXPORT_WAITS,
    EXPORT_HANDLERS,
    EXPORT_SYSTEMS,
    EXPORT_MESSAGES,
    EXPORT_BLOCKS,
    EXPORT_TABLES, /* as a choice: pieces and messages, a file each */
};

/* EXPORT_FORMATS, EXPORT_TABLES: there is none of that name, or that such a file's name ends in. */
enum export_format export_format_named(const char *name);
enum export_format export_format_of_file(const char *path);
enum export_table export_table_named(const char *name);
const char *export_format_name(enum export_format f);

struct export_request {
    enum export_format format;
    enum export_table table; /* of csv */
    const char *out; /* the file, or the folder of otf2; "-": standard output, which otf2 cannot use */
    FILE *progress;  /* a terminal that is shown how far the work is; NULL: none */
};

/* The files that are written, malloc'd, ended by NULL, as are the names: for a request that is for
 * EXPORT_TABLES of csv, as OUT.csv, these are OUT-pieces.csv and OUT-messages.csv. */
char **export_files(const struct export_request *r);

/* Writes the trace. False with *error (malloc'd, for the user); an unfinished file is not left behind. */
bool export_write(const struct trace *t, const struct export_request *r, char **error);
#endif
