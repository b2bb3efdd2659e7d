/* unserved.c - the calls that nothing else here serves, those of host programs foremost: errors. The definitions are weak,
 * so that one that is served takes precedence when the library's objects are linked into one. */
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
