/* held.c - an irecv has the message, and nobody has waited for its id. */
#include "nx.h"

int main(void)
{
    char early[8], buf[8] = "";

    if (mynode() == 0) {
        irecv(7, early, sizeof early);
        crecv(7, buf, sizeof buf);
    } else {
        csend(7, buf, sizeof buf, 0, 0);
    }
    return 0;
}
