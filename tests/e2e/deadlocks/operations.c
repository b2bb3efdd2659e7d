/* operations.c - the halves of the nodes call two global operations in different orders. */
#include "nx.h"

int main(void)
{
    double x = mynode(), work;

    if (mynode() % 2) {
        gsync();
        gdsum(&x, 1, &work);
    } else {
        gdsum(&x, 1, &work);
        gsync();
    }
    return 0;
}
