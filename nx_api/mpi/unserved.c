/* unserved.c - the calls that no other file serves, mainly those of host programs: they are errors. The
 * definitions are weak: when the library's objects are linked into one, a call's real definition precedes the
 * one here. */
#include <errno.h>
#include "nx_api/calls/call.h"
#pragma GCC diagnostic ignored "-Wunused-parameter"

static long unserved(const char *call)
{
    return node_error(
        node_self(), ENOSYS,
        "%s is not served on MPI: mpirun starts one program on all nodes, and no host program runs", call);
}

#define NX_CALL(name, parameters, arguments)                                                                 \
    __attribute__((weak)) long nxs_##name parameters                                                         \
    {                                                                                                        \
        return unserved(#name);                                                                              \
    }
#define NX_VALUE(name, expression)
#define NX_OTHER(name)
#include "nx_api/contract/calls.def"
