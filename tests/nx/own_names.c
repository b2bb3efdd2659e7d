/* A program may have functions and variables of its own by the names of calls that it does not use.
 * run: -m ipsc860 -n 2
 */
#include <nx.h>
#include <stdio.h>

long load = 3;

long handler(long x)
{
    return x + load;
}

int waitpid(void)
{
    return 1;
}

/* As one that includes nothing does. */
double kill(double x)
{
    return x / 2;
}

int main(void)
{
    long sum = handler(mynode()) + waitpid(), work;
    gisum(&sum, 1, &work);
    if (mynode() == 0)
        printf("%ld %g\n", sum, kill(3));
    return 0;
}
