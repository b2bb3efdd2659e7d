/* host_errno.c - see host_errno.h. */
#include "guest/host_errno.h"
#include <errno.h>
#include "kernel/opaque.h"

OPAQUE int node_errno(void)
{
    return errno;
}

OPAQUE void node_set_errno(int error)
{
    errno = error;
}
