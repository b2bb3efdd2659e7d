/* sim_errors.c - errors as simulated programs and their users see them. */
#include <errno.h>
#include <stdio.h>
#include <unistd.h>
#include "guest/libc/libc_parts.h"
#include "nx_api/calls/call.h"

/* If errno is of the node's last error, the text is that error's own. */
void node_nxperror(const char *what)
{
    struct node *n = node_self();
    int code = errno;
    const struct node_error *last = nx_last_error(n);
    fprintf(stream_standard(n, STDERR_FILENO), "(%s, ptype %ld) %s: %s\n", n->cold->name, n->pid,
            what ? what : "", code == last->code ? last->text : node_strerror(code));
}

/* For calls that are node code themselves (nx_api/common): ends the process with a message that names call
 * and node, as a plain call does. */
_Noreturn void node_nx_fail(const char *call, int error)
{
    struct node *n = node_self();
    node_enter(n, call);
    node_fail(n, "%s: %s", call, node_strerror(error));
}

/* For the program's run-time library (nx_api/libgfortran), which words its messages itself. frame: see
 * node_fail_in. */
_Noreturn void node_nx_die(const char *text, const void *frame)
{
    struct node *n = node_self();
    node_libc_flush(n);
    node_fail_in(n, frame, "%s", text);
}
