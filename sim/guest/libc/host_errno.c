/* host_errno.c - see host_errno.h. */
#include "guest/libc/host_errno.h"
#include <errno.h>
#include "kernel/crossing.h"
#include "kernel/fiber.h"
#include "kernel/opaque.h"

OPAQUE int node_errno(void)
{
    return errno;
}

int *node___errno_location(void)
{
    return &((struct crossing_top *)fiber_current()->program_top)->own_errno;
}

OPAQUE void node_set_errno(int error)
{
    errno = error;
}
