/* ended.c - node 1 ends before the last global operation. */
#include "nx.h"

int main(void)
{
    long one = 1, work;

    gisum(&one, 1, &work);
    if (mynode() == 1)
        return 0;
    gisum(&one, 1, &work);
    return 0;
}
