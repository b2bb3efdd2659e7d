/* creadv, cwritev, ireadv, iwritev: parts of memory lie one behind the other in the file, nothing between.
 * The list of parts may be used again when the call has returned.
 * again: --long32
 * run: all
 * run: -m paragon -n 4
 */
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/uio.h>
#include <unistd.h>
#include "rule.h"

enum { LONG = 70000 }; /* several blocks of the file system */

static char head[4], body[LONG], tail[3], all[LONG + 8];

static void fill(int shift)
{
    memset(head, 'h' + shift, sizeof head);
    memset(tail, 't' + shift, sizeof tail);
    for (int i = 0; i < LONG; i++)
        body[i] = (char)(i % 101 + shift);
}

static int is_filled(int shift)
{
    static char before[LONG];
    memcpy(before, body, LONG);
    int holds = head[0] == 'h' + shift && head[3] == 'h' + shift && tail[2] == 't' + shift;
    fill(shift);
    return holds && memcmp(before, body, LONG) == 0;
}

static void errors(int fd)
{
    struct iovec parts[2] = {{head, 4}, {0, 3}};
    rule("a null pointer",
         _cwritev(fd, parts, 2) == -1 && errno == EQPBUF && _ireadv(fd, parts, 2) == -1 && errno == EQPBUF);
    rule("no list of parts", _cwritev(fd, 0, 1) == -1 && errno == EQPBUF);
    rule("a number of parts",
         _creadv(fd, parts, -1) == -1 && errno == EQLEN && _iwritev(fd, parts, 1025) == -1 && errno == EQLEN);
    rule("no file",
         _cwritev(99, parts, 1) == -1 && errno == EBADF && _ireadv(99, parts, 1) == -1 && errno == EBADF);
    parts[1].iov_len = 0;
    rule("an empty part may be null", lseek(fd, 0, SEEK_SET) == 0 && creadv(fd, parts, 2) == 4);
    rule("no parts", creadv(fd, parts, 0) == 0 && lseek(fd, 0, SEEK_CUR) == 4);
}

static void use(const char *path)
{
    char name[60];
    struct iovec parts[3] = {{head, 4}, {body, LONG}, {tail, 3}};
    long id;
    snprintf(name, sizeof name, "%s%ld", path, mynode());
    int fd = open(name, O_RDWR | O_CREAT | O_TRUNC, 0644);
    fill(0);
    rule("cwritev", cwritev(fd, parts, 3) == LONG + 7);
    rule("in the file", lseek(fd, 0, SEEK_SET) == 0 && cread(fd, all, LONG + 8) == LONG + 7 &&
                            !memcmp(all, head, 4) && !memcmp(all + 4, body, LONG) &&
                            !memcmp(all + 4 + LONG, tail, 3));
    fill(1);
    id = iwritev(fd, parts, 3);
    memset(parts, 0, sizeof parts);
    rule("iwritev", id > 0 && iowait(id) == LONG + 7 && lseek(fd, 0, SEEK_END) == 2 * (LONG + 7));
    fill(2);
    parts[0] = (struct iovec){head, 4}, parts[1] = (struct iovec){body, LONG};
    parts[2] = (struct iovec){tail, 3};
    lseek(fd, 0, SEEK_SET);
    id = ireadv(fd, parts, 3);
    memset(parts, 0, sizeof parts);
    rule("ireadv", iowait(id) == LONG + 7 && is_filled(0));
    parts[0] = (struct iovec){head, 4}, parts[1] = (struct iovec){body, LONG};
    parts[2] = (struct iovec){tail, 3};
    rule("creadv", creadv(fd, parts, 3) == LONG + 7 && is_filled(1));
    lseek(fd, -5, SEEK_END);
    rule("as much as there is", creadv(fd, parts, 3) == 5 && creadv(fd, parts, 3) == 0);
    errors(fd);
    close(fd);
    gsync();
    unlink(name);
}

int main(void)
{
    use("/cfs/in_parts");
    use("in_parts.tmp");
    return 0;
}
