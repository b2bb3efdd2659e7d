/* I/O modes of a shared file: 0 own pointers; 1 one pointer, no two calls overlap; 2 node order, any lengths;
 * 3 node order, equal lengths.
 * run: -m ipsc860 -n 5
 * run: -m delta -n 5
 * run: -m delta -n 5 --slice 0.00001
 */
#include <fcntl.h>
#include <nx.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static char all[1 << 16];

/* What the file holds, as runs of equal characters, on node 0. */
static void show(const char *what, int fd)
{
    long i, n, start = 0;
    gsync();
    if (mynode() == 0) {
        setiomode(fd, M_UNIX);
        lseek(fd, 0, SEEK_SET);
        n = cread(fd, all, sizeof all);
        printf("%s: %ld bytes:", what, n);
        for (i = 1; i <= n; i++)
            if (i == n || all[i] != all[start])
                printf(" %c*%ld", all[start], i - start), start = i;
        printf("\n");
    }
    gsync();
    close(fd);
}

static int fresh(int mode)
{
    return gopen("/cfs/modes", O_RDWR | O_CREAT | O_TRUNC, mode, 0666);
}

/* Higher nodes call first, so that the order is not that of the calls. */
static void dawdle(void)
{
    usleep(50000 * (unsigned)(numnodes() - mynode()));
}

/* Output in the order of nodes, whatever the machine. */
static void my_turn(void)
{
    long i;
    gsync();
    for (i = 0; i < mynode(); i++)
        usleep(1000);
}

int main(void)
{
    char mine[6000];
    long me = mynode(), i, n, count[26] = {0};
    int fd;
    memset(mine, 'a' + (int)me, sizeof mine);

    fd = fresh(M_UNIX);
    lseek(fd, (numnodes() - 1 - me) * 5000, SEEK_SET);
    dawdle();
    cwrite(fd, mine, 5000);
    show("own pointers", fd);

    fd = fresh(M_LOG);
    dawdle();
    for (i = 0; i < 3; i++)
        cwrite(fd, mine, 100 * (me + 1));
    gsync();
    if (me == 0) {
        setiomode(fd, M_UNIX);
        lseek(fd, 0, SEEK_SET);
        n = cread(fd, all, sizeof all);
        for (i = 0; i < n; i++)
            count[all[i] - 'a']++;
        printf("first come: %ld bytes, last node first: %c;", n, all[0]);
        for (i = 0; i < numnodes(); i++)
            printf(" %c*%ld", (int)('a' + i), count[i]);
        printf("\n");
    }
    gsync();
    close(fd);

    fd = fresh(M_SYNC);
    dawdle();
    cwrite(fd, mine, 1000 * (me + 1));
    cwrite(fd, mine, 10);
    show("ordered", fd);

    fd = fresh(M_RECORD);
    dawdle();
    cwrite(fd, mine, 5000);
    cwrite(fd, mine, 70);
    show("records", fd);

    fd = gopen("/cfs/modes", O_RDONLY, M_SYNC, 0);
    dawdle();
    n = cread(fd, mine, me == 2 ? 5000 : 2500);
    my_turn();
    printf("node %ld reads %ld in order: %c..%c, mode %ld\n", me, n, mine[0], mine[n - 1], iomode(fd));
    gsync();
    close(fd);

    fd = gopen("/cfs/modes", O_RDONLY, M_RECORD, 0);
    n = cread(fd, mine, 6000);
    my_turn();
    printf("node %ld reads %ld as a record: %c..%c, at end %ld\n", me, n, n ? mine[0] : '-',
           n ? mine[n - 1] : '-', iseof(fd));
    return 0;
}
