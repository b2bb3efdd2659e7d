/* later.c - iread and iwrite go on while the program computes, waits and ends. "fifo" is a pipe; node 0 reads what node 1, or
 * the test, writes there.
 *
 *     later overlaps      a read waits for its input; meanwhile the program sends, and its handlers run in iowait
 *     later order         a file's transfers keep their order, and C's calls see them; a buffer is free behind iwrite
 *     later records       M_RECORD: nodes' parts of rounds are where they belong
 *     later errors        errors are told by iowait, or at once
 *     later fails         the same by a plain call
 *     later ends          the program ends before its writes
 *     later alive         node 0 waits for its input only, and node 1 for node 0: no deadlock
 *     later deadlock      a deadlock while a read waits for its input
 */
#include <errno.h>
#include <fcntl.h>
#include <nx.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { PART = 1000, PARTS = 100, LARGE = 1 << 20 };
static char in[LARGE], out[LARGE];
static long box;

static void handler(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)pid;
    csend(3, &box, sizeof box, node, 0);
}

static void overlaps(void)
{
    int fd = open("fifo", O_RDWR);
    if (mynode() == 1) {
        crecv(1, NULL, 0);
        csend(2, &box, sizeof box, 0, 0); /* for the handler, whose answer comes while node 0 is in iowait */
        crecv(3, &box, sizeof box);
        if (write(fd, "hello", 5) != 5)
            printf("wrong\n");
        gsync();
        return;
    }
    hrecv(2, &box, sizeof box, handler);
    long id = iread(fd, in, 5), done = iodone(id);
    csend(1, NULL, 0, 1, 0);
    printf("done at first: %ld\n", done);
    printf("read: %ld, %s\n", iowait(id), in);
    gsync();
}

static void order(void)
{
    int fd = gopen("/cfs/order", O_RDWR | O_CREAT | O_TRUNC, M_UNIX, 0666), i, wrong = 0;
    long ids[PARTS];
    for (i = 0; i < PARTS; i++) {
        memset(out, i + 1, PART);
        ids[i] = iwrite(fd, out, PART);
    }
    printf("length: %ld\n", (long)lseek(fd, 0, SEEK_END));
    lseek(fd, 0, SEEK_SET);
    for (i = 0; i < PARTS; i++)
        if (iowait(ids[i]) != PART)
            wrong++;
    for (i = 0; i < PARTS; i++)
        ids[i] = iread(fd, in + i * PART, PART);
    for (i = 0; i < PARTS; i++)
        while (!iodone(ids[i]))
            ;
    for (i = 0; i < PARTS * PART; i++)
        wrong += in[i] != i / PART + 1;
    long end = iread(fd, in, PART), at = ireadoff(fd, (esize_t){.slow = 5 * PART}, in, PART);
    end = iowait(end), at = iowait(at);
    printf("at the end: %ld; at an offset: %ld, %d; wrong: %d\n", end, at, in[0], wrong);
}

static void records(void)
{
    int fd = gopen("/cfs/records", O_RDWR | O_CREAT | O_TRUNC, M_RECORD, 0666), i, wrong = 0;
    long me = mynode(), nodes = numnodes(), ids[PARTS];
    for (i = 0; i < PARTS; i++) {
        memset(out, (int)(i * nodes + me), PART);
        ids[i] = iwrite(fd, out, PART);
    }
    for (i = 0; i < PARTS; i++)
        iowait(ids[i]);
    gsync();
    lseek(fd, 0, SEEK_SET);
    int same = open("/cfs/records", O_RDONLY);
    for (i = 0; i < PARTS * nodes; i++)
        wrong += read(same, in, PART) != PART || in[0] != (char)i || in[PART - 1] != (char)i;
    gsync();
    printf("%d wrong, eof %ld\n", wrong, iseof(fd));
}

static void errors(void)
{
    int fd = open("/dev/full", O_WRONLY), some = open("some", O_WRONLY | O_CREAT, 0666);
    long id = iwrite(fd, out, 10), result = _iowait(id);
    printf("iowait: %ld, %s\n", result, strerror(errno));
    result = _iodone(id);
    printf("its id is free: %ld\n", result);
    result = _iread(some, in, 10);
    printf("iread: %ld, %s\n", result, strerror(errno));
}

static void fails(void)
{
    iowait(iwrite(open("/dev/full", O_WRONLY), out, 10));
}

static void ends(void)
{
    int fd = gopen("/cfs/ends", O_RDWR | O_CREAT | O_TRUNC, M_UNIX, 0666), i;
    memset(out, 'x', sizeof out);
    for (i = 0; i < 50; i++)
        iwrite(fd, out, LARGE);
}

static void alive(int deadlock)
{
    if (mynode() == 0) {
        long id = iread(open("fifo", O_RDWR), in, 5);
        if (deadlock)
            crecv(5, NULL, 0);
        printf("read: %ld\n", iowait(id));
        csend(4, NULL, 0, 1, 0);
    } else {
        crecv(4, NULL, 0);
        printf("heard\n");
    }
}

int main(int argc, char **argv)
{
    const char *what = argc > 1 ? argv[1] : "";
    if (strcmp(what, "overlaps") == 0)
        overlaps();
    else if (strcmp(what, "order") == 0)
        order();
    else if (strcmp(what, "records") == 0)
        records();
    else if (strcmp(what, "errors") == 0)
        errors();
    else if (strcmp(what, "fails") == 0)
        fails();
    else if (strcmp(what, "ends") == 0)
        ends();
    else
        alive(strcmp(what, "deadlock") == 0);
    return 0;
}
