/* waitfor_operation.c - the global operations behind the message types that NX's library keeps for itself
 * (nx_api/common/global.h): reports name the call that the program has made, not the messages that it is
 * made of. */
#include <string.h>
#include "nx_api/common/global.h"
#include "nx_api/waitfor/waitfor_parts.h"

static const char GCOL[] = "gcol"; /* one operation, though it has two kinds of messages */

#define REDUCTION(name, operation, element, expression) [operation] = #name,
static const char *const NAMES[] = {
    [GSYNC] = "gsync",
#include "nx_api/common/reductions.def"
    [GOPF] = "gopf",
    [GLOBAL_GCOL] = GCOL,
    [GLOBAL_GCOL_LENGTHS] = GCOL,
};

const char *waitfor_operation(long type)
{
    enum { OPERATIONS = sizeof NAMES / sizeof *NAMES, FORCED = 1 << 30 };
    if (type < GLOBAL_FIRST_TYPE || type >= FORCED)
        return NULL;
    long operation = (type - GLOBAL_FIRST_TYPE) / GLOBAL_TYPES;
    return operation < OPERATIONS && NAMES[operation] ? NAMES[operation] : "a call of the library";
}
