/* I/O mode M_GLOBAL: all nodes read the same, each gets all of it; they write the same, and it is there once.
 * run: all
 */
#include <fcntl.h>
#include <string.h>
#include <unistd.h>
#include "rule.h"

int main(void)
{
    char text[16] = "";
    int fd = gopen("/cfs/global", O_RDWR | O_CREAT | O_TRUNC, M_GLOBAL, 0644);
    rule("writing", cwrite(fd, "from every node", 16) == 16);
    gsync();
    lseek(fd, 0, SEEK_SET);
    rule("reading", cread(fd, text, 16) == 16 && strcmp(text, "from every node") == 0);
    rule("at the end", iseof(fd) == 1 && cread(fd, text, 16) == 0);
    setiomode(fd, M_ASYNC);
    close(fd);
    gsync();
    if (mynode() == 0)
        unlink("/cfs/global");
    return 0;
}
