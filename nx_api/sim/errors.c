/* errors.c - what programs are told of errors. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include "guest/libc_parts.h"
#include "nx_api/sim/call.h"
#include "node/self.h"
#include "os/fail.h"
#include "os/gate.h"

char *node_strerror(int code)
{
    const char *text = nx_error_text(code);
    return text ? (char *)(uintptr_t)text : strerror(code);
}

/* The error's own text, if it is the last one's. */
void node_nxperror(const char *what)
{
    struct node *n = node_self();
    int code = errno;
    fprintf(n->libc->streams.err, "(%s, ptype %ld) %s: %s\n", n->name, n->pid, what ? what : "",
            code == n->error->code ? n->error->text : node_strerror(code));
}

/* For the calls that are node programs themselves (nx_api/common): ends the process with a message that names call and
 * node, as a plain call does. */
_Noreturn void node_nx_fail(const char *call, int error)
{
    struct node *n = node_self();
    node_enter(n, call);
    node_fail(n, "%s: %s", call, node_strerror(error));
}

/* The same for a run-time library of the program, which has its own words: nx_api/libgfortran. frame: node_fail_in. */
_Noreturn void node_nx_die(const char *text, const void *frame)
{
    struct node *n = node_self();
    node_libc_flush(n);
    node_fail_in(n, frame, "%s", text);
}
