/* I/O mode 3: nodes that give different lengths in a round end the program.
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 */
#include <fcntl.h>
#include <nx.h>
#include <stdio.h>

int main(void)
{
    static char buf[100];
    int fd = gopen("/cfs/lengths", O_RDWR | O_CREAT, M_RECORD, 0666);
    gsync();
    if (mynode() == 0)
        cwrite(fd, buf, 100);
    gsync();
    cwrite(fd, buf, mynode() == 1 ? 99 : 100);
    gsync();
    printf("not reached\n");
    return 0;
}
