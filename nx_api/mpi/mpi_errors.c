/* mpi_errors.c - errors as programs on MPI see them: NX's values among those of the C library. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include "nx_api/calls/call.h"
#include "nx_api/contract/error_text.h"

char *node_strerror(int code) NX_EXPORT("strerror");
void node_perror(const char *what) NX_EXPORT("perror");

char *node_strerror(int code)
{
    static char unknown[40];
    const char *text = nx_error_text(code);
    if (!text && !(text = strerrordesc_np(code))) {
        snprintf(unknown, sizeof unknown, "Unknown error %d", code);
        text = unknown;
    }
    return (char *)(uintptr_t)text;
}

void node_perror(const char *what)
{
    int code = errno;
    fprintf(stderr, "%s%s%s\n", what ? what : "", what && *what ? ": " : "", node_strerror(code));
}

void node_nxperror(const char *what) NX_EXPORT("nxperror");
/* For calls of nx_api/common: ends the process with a message that names call and node. */
_Noreturn void node_nx_fail(const char *call, int error) NX_EXPORT("nx_fail");

/* If errno is of the node's last error, the text is that error's own. */
void node_nxperror(const char *what)
{
    struct node *n = node_self();
    int code = errno;
    fprintf(stderr, "(node %ld, ptype %ld) %s: %s\n", n->id, n->pid, what ? what : "",
            code == n->error.code ? n->error.text : node_strerror(code));
}

_Noreturn void node_nx_fail(const char *call, int error)
{
    node_fail(node_self(), "%s: %s", call, node_strerror(error));
}
