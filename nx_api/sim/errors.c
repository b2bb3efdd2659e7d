/* errors.c - NX's errno values as text, for programs that ask. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include "node/image.h"
#include "node/libc_parts.h"
#include "nx_api/sim/call.h"

static const char *const texts[] = {
    [EQPBUF - EQPBUF] = "a buffer is no valid pointer",
    [EQBLEN - EQPBUF] = "a buffer is too short for the result",
    [EQLEN - EQPBUF] = "a length or count is out of range",
    [EQMSGLONG - EQPBUF] = "the message received is longer than the buffer",
    [EQPID - EQPBUF] = "a process id is out of range",
    [EQNODE - EQPBUF] = "there is no such node",
    [EQTYPE - EQPBUF] = "a message type is out of range",
    [EQMID - EQPBUF] = "no message id in use",
    [EQMEM - EQPBUF] = "the node's memory is used up",
    [EQNOMID - EQPBUF] = "all message ids are in use",
    [EQSET - EQPBUF] = "the process id is set already",
    [EQNOSET - EQPBUF] = "no process id has been set",
    [EQUSEPID - EQPBUF] = "the process id is another process's",
    [EQHND - EQPBUF] = "the handler is a null pointer",
    [EQNOPROC - EQPBUF] = "no such process",
};

char *node_strerror(int code)
{
    size_t i = (size_t)code - EQPBUF;
    return code >= EQPBUF && i < sizeof texts / sizeof *texts ? (char *)(uintptr_t)texts[i] : strerror(code);
}

/* The error's own text, if it is the last one's. */
void node_nxperror(const char *what)
{
    struct node *n = node_self();
    int code = errno;
    fprintf(n->libc->streams.err, "(%s, ptype %ld) %s: %s\n", n->name, n->pid, what ? what : "",
            code == n->error.code ? n->error.text : node_strerror(code));
}

/* For the calls that are node programs themselves (nx_api/common): ends the process with a message that names call and
 * node, as a plain call does. */
_Noreturn void node_nx_fail(const char *call, int error)
{
    struct node *n = node_self();
    node_enter(n, call);
    node_fail(n, "%s: %s", call, node_strerror(error));
}

/* The same for a run-time library of the program, which has its own words: nx_api/libgfortran. address, if not NULL, is
 * where it was called from. */
_Noreturn void node_nx_die(const char *text, const void *address)
{
    char where[128];
    struct node *n = node_self();
    node_libc_flush(n);
    if (!address)
        node_fail(n, "%s", text);
    node_fail(n, "%s, at %s", text,
              node_image_where(n->file, (size_t)((const char *)address - 1 - n->span), where, sizeof where));
}
