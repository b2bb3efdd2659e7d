/* wrong_type.c - node 0 waits for type 7; what has come is of other types. */
#include "nx.h"

int main(void)
{
    char buf[8] = "";

    if (mynode() == 0) {
        crecv(7, buf, sizeof buf);
    } else {
        csend(8, buf, sizeof buf, 0, 0);
        if (mynode() == 2)
            csend(9, buf, sizeof buf, 0, 0);
    }
    gsync();
    return 0;
}
