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

/* Records: seeks from where the pointer is, and to the end and back, move it once, however far other nodes
 * have come. */
static int moves_once(int fd)
{
    int first = (int)(mynode() + 1) * 1000, good = lseek(fd, 3, SEEK_SET) == 3;
    usleep((unsigned)first);
    good &= lseek(fd, 2, SEEK_CUR) == 5 && lseek(fd, 1, SEEK_CUR) == 6 && lseek(fd, 0, SEEK_CUR) == 6;
    cread(fd, in, 1);
    good &= in[0] == '6' + (char)mynode();
    gsync();
    usleep((unsigned)first);
    good &= lseek(fd, 0, SEEK_END) == 40 && lseek(fd, 1, SEEK_SET) == 1;
    cread(fd, in, 1);
    return good && in[0] == '1' + (char)mynode();
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
        if (mode == M_RECORD)
            rule("from where it is, and to the end and back", moves_once(fd));
    }
    return 0;
}
