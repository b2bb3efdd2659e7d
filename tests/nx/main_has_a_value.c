/* A main that falls off its end, or returns something, has not failed: in 1990 what it left was anything.
 * run: all
 */
#include <nx.h>
#include <stdio.h>

int main(void)
{
    gsync();
    if (mynode() == 0)
        printf("ends with 77\n");
    return 77;
}
