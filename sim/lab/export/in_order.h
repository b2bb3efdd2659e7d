/* in_order.h - lines of text that are made node by node, and written in order of time: formats that are one
 * stream of all nodes' events need that. The lines wait in a temporary file, so that memory holds a few
 * kilobytes a stream. */
#ifndef LAB_EXPORT_IN_ORDER_H
#define LAB_EXPORT_IN_ORDER_H
#include <stdbool.h>
#include <stdio.h>
#include "kernel/vtime.h"

struct in_order;

/* NULL with *error (malloc'd) if there is no room for temporary files. */
struct in_order *in_order_new(char **error);
/* Begins a stream. Lines of equal times come in the order of their streams. */
void in_order_stream(struct in_order *o);
/* Adds a line to the stream. One that should come before the stream's last, as in a damaged trace, comes
 * behind. */
void in_order_line(struct in_order *o, vtime time, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* Writes all lines, in order of time. False with *error (malloc'd) if the temporary file failed; whether
 * `out` did, it says itself. */
bool in_order_write(struct in_order *o, FILE *out, char **error);
void in_order_free(struct in_order *o);
#endif
