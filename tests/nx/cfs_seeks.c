/* lseek and eseek set the pointer that nodes share, in every I/O mode; in those in which all nodes take part
 * all seek.
 * run: -m ipsc860 -n 2
 * run: -m delta -n 3
 */
#include <fcntl.h>
#include <unistd.h>
#include "rule.h"

static char bytes[40], in[8];

/* All have gone there, and read a byte each, in turn but for M_LOG; their own one in M_UNIX, one for all in
 * M_GLOBAL. */
static int reads_at(int fd, long mode, char first)
{
    gsync();
    cread(fd, in, 1);
    gsync();
    if (mode == M_LOG)
        return in[0] >= first && in[0] < first + numnodes();
    return in[0] == (mode == M_UNIX || mode == M_GLOBAL ? first : first + (char)mynode());
}

int main(void)
{
    static const char *const name[] = {"M_UNIX", "M_LOG", "M_SYNC", "M_RECORD", "M_GLOBAL"};
    for (int i = 0; i < 40; i++)
        bytes[i] = (char)('0' + i);
    int fd = gopen("/cfs/seeks", O_RDWR | O_CREAT | O_TRUNC, M_UNIX, 0666);
    if (mynode() == 0)
        cwrite(fd, bytes, 40);
    gsync();
    for (long mode = M_UNIX; mode <= M_GLOBAL; mode++) {
        lseek(fd, 0, SEEK_SET);
        setiomode(fd, (int)mode);
        int set = lseek(fd, 5, SEEK_SET) == 5;
        set &= reads_at(fd, mode, '5');
        set &= reads_at(fd, mode, mode == M_UNIX || mode == M_GLOBAL ? '6' : '5' + (char)numnodes());
        rule(name[mode], set);
        set = eseek(fd, (esize_t){-10, -1}, SEEK_END).slow == 30;
        rule("from the end", set & reads_at(fd, mode, 'N'));
        gsync();
        lseek(fd, 7, SEEK_SET);
        rule("again", reads_at(fd, mode, '7'));
    }
    return 0;
}
