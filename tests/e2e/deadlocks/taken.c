/* taken.c - a receive of any type takes the message for which node 0 waits afterwards. */
#include "nx.h"

enum { REQUEST = 3, RESULT = 7 };

int main(void)
{
    char buf[8] = "";

    if (mynode() == 1) {
        csend(RESULT, buf, sizeof buf, 0, 0);
        csend(REQUEST, buf, sizeof buf, 0, 0);
    } else if (mynode() == 0) {
        crecv(-1, buf, sizeof buf); /* the request, it is assumed */
        crecv(RESULT, buf, sizeof buf);
    }
    gsync();
    return 0;
}
