/* forced.c - a message of a forced type comes before its receive is posted. */
#include "nx.h"

enum { FORCED = 1 << 30 };

int main(void)
{
    char buf[8] = "";

    if (mynode() == 0) {
        crecv(1, buf, sizeof buf);
        crecv(FORCED + 2, buf, sizeof buf);
    } else {
        csend(FORCED + 2, buf, sizeof buf, 0, 0);
        csend(1, buf, sizeof buf, 0, 0);
    }
    return 0;
}
