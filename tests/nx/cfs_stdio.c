/* The C library's streams and POSIX calls work on /cfs; so do sizes, seeks, the end of the file, and parts.
 * again: --long32
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 */
#include <errno.h>
#include <estat.h>
#include <fcntl.h>
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

static void streams(void)
{
    char line[80];
    int number = 0;
    long i;
    FILE *f = fopen("/cfs/some/folder/text", "w");
    for (i = 0; i < 2000; i++)
        fprintf(f, "line %ld\n", i);
    printf("wrote to %ld\n", ftell(f));
    fclose(f);
    f = fopen("/cfs/some/folder/text", "a+");
    fprintf(f, "the last\n");
    fseek(f, -19, SEEK_END);
    while (fgets(line, sizeof line, f))
        printf("[%s]", strtok(line, "\n"));
    rewind(f);
    fscanf(f, "line %*d line %d", &number);
    printf(" %d\n", number);
    fclose(f);
    f = fopen("/cfs/none", "r");
    printf("a missing file: %s, %s\n", f ? "opened" : "not opened", strerror(errno));
    printf("out of /cfs: %s\n", fopen("/cfs/../etc/passwd", "r") ? "opened" : strerror(errno));
}

static void sizes(void)
{
    int fd = creat("/cfs/sizes", 0666);
    struct stat st;
    struct estat e;
    esize_t far = {4096, 1}, at;
    char a[10], b[10];
    struct iovec parts[2] = {{a, 3}, {b, 10}};
    printf("write %ld, ", (long)write(fd, "0123456789", 10));
    printf("read what is not to be read %ld, ", (long)read(fd, a, 10));
    close(fd);
    fd = open("/cfs/sizes", O_RDWR);
    printf("seek %ld, ", (long)lseek(fd, -2, SEEK_END));
    printf("at end %ld, ", iseof(fd));
    printf("read %ld, ", (long)read(fd, a, 10));
    printf("at end %ld\n", iseof(fd));
    printf("sizes %ld ", lsize(fd, 100, SIZE_SET));
    printf("%ld ", lsize(fd, 50, SIZE_SET));
    printf("%ld\n", lsize(fd, 7, SIZE_END));
    stat("/cfs/sizes", &st);
    estat("/cfs/sizes", &e);
    printf("stat %ld, estat %ld %ld\n", (long)st.st_size, e.st_size.slow, e.st_size.shigh);
    at = esize(fd, far, SIZE_SET);
    printf("esize %ld %ld ", at.slow, at.shigh);
    at.slow = -3, at.shigh = -1;
    at = eseek(fd, at, SEEK_END);
    printf("eseek %ld %ld ", at.slow, at.shigh);
    cwrite(fd, "xyz", 3);
    festat(fd, &e);
    printf("festat %ld %ld\n", e.st_size.slow, e.st_size.shigh);
    lseek(fd, 0, SEEK_SET);
    printf("parts %ld %.3s %.7s\n", creadv(fd, parts, 2), a, b);
    close(fd);
    printf("unlink %d ", unlink("/cfs/sizes"));
    printf("again %d\n", unlink("/cfs/sizes"));
    printf("not open: %ld\n", (long)write(fd, a, 3));
    write(1, "to the output\n", 14);
}

int main(void)
{
    static const int disks[] = {2, 0};
    int fd;
    if (mynode() == 0) {
        streams();
        sizes();
    }
    fd = gopen("/cfs/two_disks", O_RDWR | O_CREAT, M_UNIX, 0666);
    restrictvol(fd, 2, disks);
    lseek(fd, mynode() * 40000, SEEK_SET);
    cwrite(fd, calloc(1, 40000), 40000);
    gsync();
    if (mynode() == 1)
        printf("on two disks: %ld\n", lsize(fd, 0, SIZE_END));
    return 0;
}
