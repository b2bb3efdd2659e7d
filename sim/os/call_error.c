/* call_error.c - the error of an NX call that its program may look at: nx_api/contract/backend.h. */
#include <stdarg.h>
#include <stdio.h>
#include "node/node.h"
#include "nx_api/contract/backend.h"

long node_error(struct node *n, int code, const char *fmt, ...)
{
    va_list ap;
    va_start(ap, fmt);
    vsnprintf(n->error->text, sizeof n->error->text, fmt, ap);
    va_end(ap);
    n->error->code = code;
    return -1;
}
