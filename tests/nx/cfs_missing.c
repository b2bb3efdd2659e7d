/* gopen of a file that is not there ends the program.
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 */
#include <fcntl.h>
#include <nx.h>
#include <stdio.h>

int main(void)
{
    gopen("/cfs/none", O_RDONLY, M_UNIX, 0);
    printf("not reached\n");
    return 0;
}
