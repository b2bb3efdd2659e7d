/* I/O mode M_GLOBAL: all nodes make the same calls, and one read or write serves all: each gets the data, and
 * what they write is there once. Asynchronously, through the C library and at the end of the file too; a file
 * longer than many blocks.
 * run: all
 * run: -m paragon -n 5
 * run: -m paragon95 -n 8 --slice 0.00001
 */
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "rule.h"

static char text[16], many[100000], back[2 * 60000];

static int is_pattern(const char *p, long from, long n)
{
    for (long i = 0; i < n; i++)
        if (p[i] != (char)((from + i) * 7 % 251))
            return 0;
    return 1;
}

/* Nodes come at different times, the last first. */
static void come(void)
{
    double until = dclock() + 1e-3 * (double)(numnodes() - mynode());
    while (dclock() < until)
        ;
}

int main(void)
{
    int fd = gopen("/cfs/global", O_RDWR | O_CREAT | O_TRUNC, M_GLOBAL, 0644);
    long first, second;
    FILE *f;
    rule("the mode", iomode(fd) == M_GLOBAL);
    come();
    rule("writing", cwrite(fd, "from every node", 16) == 16);
    lseek(fd, 0, SEEK_SET);
    come();
    rule("reading", cread(fd, text, 16) == 16 && strcmp(text, "from every node") == 0);
    rule("at the end", iseof(fd) == 1 && cread(fd, text, 16) == 0);

    for (long i = 0; i < (long)sizeof many; i++)
        many[i] = (char)(i * 7 % 251);
    lseek(fd, 0, SEEK_SET);
    come();
    rule("writing much", write(fd, many, sizeof many) == sizeof many);
    lseek(fd, 0, SEEK_SET);
    come();
    first = iread(fd, back, 60000);
    second = iread(fd, back + 60000, 60000);
    rule("how much asynchronous reads read", iowait(second) == 40000 && iowait(first) == 60000);
    rule("what they read", is_pattern(back, 0, sizeof many));

    lseek(fd, 10, SEEK_SET);
    memset(back, 0, sizeof back);
    rule("the C library's read", read(fd, back, 5000) == 5000 && is_pattern(back, 10, 5000));
    rule("pointers", lseek(fd, 0, SEEK_CUR) == 5010);
    setiomode(fd, M_ASYNC);
    rule("M_ASYNC", iomode(fd) == M_ASYNC && lseek(fd, mynode(), SEEK_SET) == mynode() &&
                        cread(fd, back, 1000) == 1000 && is_pattern(back, mynode(), 1000));
    close(fd);

    f = fopen("/pfs/global", "r");
    rule("under the other name", f && fread(back, 1, 100, f) == 100 && is_pattern(back, 0, 100));
    fclose(f);
    gsync();
    if (mynode() == 0)
        unlink("/cfs/global");
    return 0;
}
