/* error_text.c - see error_text.h. */
#include "nx_api/contract/error_text.h"
#include <stddef.h>
#include "nx_api/include/nxerrno.h"

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

const char *nx_error_text(int code)
{
    size_t i = (size_t)code - EQPBUF;
    return code >= EQPBUF && i < sizeof texts / sizeof *texts ? texts[i] : NULL;
}
