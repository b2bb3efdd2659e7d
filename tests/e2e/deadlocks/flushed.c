/* flushed.c - flushmsg throws away a message that came early. */
#include "nx.h"

int main(void)
{
    char buf[8] = "";

    if (mynode() == 0) {
        crecv(1, buf, sizeof buf);
        flushmsg(-1, mynode(), 0);
        crecv(2, buf, sizeof buf);
    } else {
        csend(2, buf, sizeof buf, 0, 0);
        csend(1, buf, sizeof buf, 0, 0);
    }
    return 0;
}
