/* Calls, twice, a function that does not exist; see stubs.sh. */
#include <errno.h>
#include <stdio.h>
#include <nx.h>

extern int gadget();

int main(void)
{
    gadget(1);
    int answer = gadget(2);
    if (mynode() == 0)
        printf("gadget %d%s\n", answer, errno == ENOSYS ? " ENOSYS" : "");
    return 0;
}
