/* waitfor_analyse.c - the steps of the analysis, each in a file of its own. */
#include "nx_api/waitfor/waitfor_parts.h"

void waitfor_analyse(struct waitfor *w)
{
    waitfor_find_whom(w);
    waitfor_find_cycle(w);
    waitfor_find_causes(w);
    waitfor_find_reasons(w);
}
