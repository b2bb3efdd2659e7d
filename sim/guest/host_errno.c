/* host_errno.c - see host_errno.h. */
#include "guest/host_errno.h"
#include <errno.h>

__attribute__((noipa)) int node_errno(void)
{
    return errno;
}

__attribute__((noipa)) void node_set_errno(int error)
{
    errno = error;
}
