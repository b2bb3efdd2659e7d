/* readoff, writeoff, ireadoff and iwriteoff: at an offset of their own, in any I/O mode, pointers left alone.
 * iowait returns the bytes moved.
 * again: --long32
 * run: all
 * run: -m paragon -n 4
 */
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <unistd.h>
#include "rule.h"

static const esize_t NOWHERE = {0, -1};

static esize_t at(long place)
{
    esize_t e = {place, 0};
    return e;
}

static void use(const char *path, int mode)
{
    char text[32] = "", mine[32];
    long me = mynode(), id;
    int fd = gopen(path, O_RDWR | O_CREAT | O_TRUNC, mode, 0644);
    memset(mine, 'a' + (int)me % 26, sizeof mine);
    rule("writeoff", writeoff(fd, at(me * 20), mine, 20) == 20);
    gsync();
    rule("readoff", readoff(fd, at((numnodes() - 1) * 20 + 5), text, 30) == 15 &&
                        text[14] == 'a' + (numnodes() - 1) % 26);
    rule("the pointer is where it was", lseek(fd, 0, SEEK_CUR) == 0);
    gsync(); /* a shared pointer may move from now on */
    id = iwriteoff(fd, at(10000 + me * 10), mine, 10);
    rule("iwriteoff", id > 0 && iowait(id) == 10);
    gsync();
    id = ireadoff(fd, at(10000 + last_node() * 10), text, 10);
    rule("ireadoff", iowait(id) == 10 && text[0] == 'a' + last_node() % 26);
    id = iread(fd, text, 10);
    rule("iowait tells how much iread has read", iowait(id) == 10);
    id = iwrite(fd, text, 7);
    rule("iowait tells how much iwrite has written", iowait(id) == 7);
    rule("below 0", _readoff(fd, NOWHERE, text, 1) == -1 && errno == EINVAL);
    rule("errors", _readoff(99, at(0), text, 1) == -1 && errno == EBADF &&
                       _iwriteoff(fd, at(0), 0, 1) == -1 && errno == EQPBUF);
    close(fd);
    gsync();
    if (me == 0)
        unlink(path);
}

int main(void)
{
    esize_t far = {0, 2};
    char c = 0;
    int fd;
    use("/cfs/offsets", M_UNIX);
    use("/pfs/offsets", M_LOG);
    use("/cfs/offsets", M_RECORD);
    use("offsets.tmp", M_UNIX);
    gsync();
    fd = gopen("/cfs/far", O_RDWR | O_CREAT | O_TRUNC, M_UNIX, 0644);
    rule("beyond 32 bits",
         (mynode() || writeoff(fd, far, "x", 1) == 1) && (gsync(), readoff(fd, far, &c, 1) == 1) && c == 'x');
    rule("the size", ecmp(eseek(fd, at(0), SEEK_END), eadd(far, at(1))) == 0);
    close(fd);
    gsync();
    if (mynode() == 0)
        unlink("/cfs/far");
    return 0;
}
