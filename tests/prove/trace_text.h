/* trace_text.h - a trace as text that is the same for equal runs. */
#ifndef PROVE_TRACE_TEXT_H
#define PROVE_TRACE_TEXT_H

/* The trace's tables, a line an entry; malloc'd. "": there is no file. */
char *trace_text(const char *path);
#endif
