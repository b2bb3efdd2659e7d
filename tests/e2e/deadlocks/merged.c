/* merged.c - msgwait for two messages, of which one comes; and cprobe for a type out of a set. */
#include "nx.h"

int main(void)
{
    char a[8] = "", b[8];

    if (mynode() == 0) {
        long first = irecv(1, a, sizeof a);
        msgwait(msgmerge(first, irecv(2, b, sizeof b)));
    } else {
        csend(1, a, sizeof a, 0, 0);
        cprobe((long)(1u << 31 | 1 << 3 | 1 << 5));
    }
    return 0;
}
