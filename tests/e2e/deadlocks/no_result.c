/* no_result.c - a result of a wrong type: the master waits for it, and the slaves for the master. */
#include "nx.h"

enum { RESULT = 200, STOP = 300 };

int main(void)
{
    long result = mynode();

    if (mynode() == 0) {
        for (long i = 1; i < numnodes(); i++)
            crecv(RESULT, &result, sizeof result);
        csend(STOP, &result, sizeof result, -1, 0);
    } else {
        csend(RESULT + (mynode() == 3), &result, sizeof result, 0, 0);
        crecv(STOP, &result, sizeof result);
    }
    return 0;
}
