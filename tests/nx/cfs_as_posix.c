/* What POSIX says of files holds for those of the machine, too: what errno says and when, who may change a
 * file, and what a folder's new name is to the files in it.
 * simulator only: a cluster's files are its computers'
 * compile: -D_GNU_SOURCE
 * run: -m ipsc860 -n 3
 * run: -m paragon -n 1
 */
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "rule.h"

static char name[60], folder[60], inside[80], renamed[60], inside_renamed[80];

static int fails(long answer, int error)
{
    return answer == -1 && errno == error;
}

static int errno_stays(void)
{
    struct stat st;
    char text[8];
    errno = 77;
    int fd = open(name, O_RDWR | O_CREAT | O_TRUNC, 0600);
    int good = fd >= 0 && write(fd, "abc", 3) == 3 && lseek(fd, 0, SEEK_SET) == 0 && read(fd, text, 8) == 3;
    good = good && lseek(fd, 0, SEEK_END) == 3 && fstat(fd, &st) == 0 && stat(name, &st) == 0;
    good = good && ftruncate(fd, 2) == 0 && rename(name, inside) == 0 && rename(inside, name) == 0;
    good = good && close(fd) == 0 && errno == 77;
    int only = open(name, O_WRONLY);
    return good && fails(pread(only, text, 1, 0), EBADF) && close(only) == 0;
}

static int only_for_reading(void)
{
    struct stat st;
    int fd = open(name, O_RDONLY);
    int good = fails(ftruncate(fd, 0), EINVAL) && fails(_lsize(fd, 100, SIZE_SET), EBADF);
    return good && fstat(fd, &st) == 0 && st.st_size == 2 && close(fd) == 0;
}

static int far_places(void)
{
    int fd = open(name, O_RDWR);
    int good = lseek64(fd, INT64_MAX, SEEK_SET) == INT64_MAX && fails(write(fd, "abc", 3), EFBIG);
    good =
        good && fails(lseek64(fd, INT64_MAX, SEEK_CUR), EOVERFLOW) && fails(lseek(fd, -1, SEEK_SET), EINVAL);
    return good && fails(pwrite64(fd, "abc", 3, INT64_MAX), EFBIG) && close(fd) == 0;
}

static int long_names(void)
{
    char path[5000];
    memset(path, 'n', sizeof path);
    memcpy(path, "/cfs/", 5);
    path[sizeof path - 1] = 0;
    return fails(open(path, O_RDONLY), ENAMETOOLONG) && fails(unlink(path), ENAMETOOLONG) &&
           fails(rename(name, path), ENAMETOOLONG) && fails(open("/cfs/../x", O_RDONLY), EACCES);
}

static int long_reads(void)
{
    char text[8];
    volatile size_t most = UINT32_MAX;
    int fd = open(name, O_RDONLY);
    return read(fd, text, most) == 2 && cread(fd, text, most) == 0 && close(fd) == 0;
}

static int folders(void)
{
    struct stat st;
    char text[8] = "";
    int fd = open(inside, O_RDWR | O_CREAT, 0600), other;
    int good = fd >= 0 && rename(folder, renamed) == 0 && fails(open(inside, O_RDONLY), ENOENT);
    good = good && (other = open(inside_renamed, O_RDWR)) >= 0 && write(fd, "abc", 3) == 3;
    good = good && lseek(other, 0, SEEK_END) == 3 && lseek(other, 0, SEEK_SET) == 0;
    good = good && read(other, text, 8) == 3 && !strcmp(text, "abc") && close(fd) == 0 && close(other) == 0;
    good = good && stat(renamed, &st) == 0 && S_ISDIR(st.st_mode) && st.st_nlink == 2 && st.st_size == 0;
    good = good && fails(unlink("/cfs"), EBUSY) && fails(rename("/cfs", renamed), EBUSY);
    return good && unlink(inside_renamed) == 0 && remove(renamed) == 0;
}

static long size_of(int fd)
{
    struct stat st;
    return fstat(fd, &st) == 0 ? (long)st.st_size : -1;
}

/* A file that has lost its name is another one than the next of that name. */
static int lost_names(void)
{
    char text[8] = "";
    int fd = open(name, O_RDWR), good = unlink(name) == 0 && fails(open(name, O_RDWR), ENOENT), other, third;
    good = good && (other = open(name, O_RDWR | O_CREAT | O_EXCL, 0600)) >= 0 && size_of(other) == 0;
    good = good && write(fd, "longer", 6) == 6 && size_of(fd) == 6 && write(other, "new", 3) == 3;
    good = good && (third = creat(inside, 0600)) >= 0 && rename(name, inside) == 0 && size_of(third) == 0;
    good = good && write(third, "12", 2) == 2 && close(third) == 0 && close(fd) == 0 && size_of(other) == 3;
    good = good && (fd = open(inside, O_RDONLY)) >= 0 && unlink(inside) == 0 && close(other) == 0;
    good = good && read(fd, text, 8) == 3 && !strcmp(text, "new") && close(fd) == 0 && remove(folder) == 0;
    for (int i = 0; i < 20; i++)
        good = good && close(creat(name, 0600)) == 0 && unlink(name) == 0;
    return good && fails(unlink(name), ENOENT);
}

int main(void)
{
    long me = mynode();
    snprintf(name, sizeof name, "/cfs/file%ld", me);
    snprintf(folder, sizeof folder, "/cfs/folder%ld", me);
    snprintf(inside, sizeof inside, "%s/file", folder);
    snprintf(renamed, sizeof renamed, "/cfs/renamed%ld", me);
    snprintf(inside_renamed, sizeof inside_renamed, "%s/file", renamed);
    rule("errno stays as it was unless there is an error", errno_stays());
    rule("a file open for reading is not changed", only_for_reading());
    rule("places that no file has", far_places());
    rule("names that are too long", long_names());
    rule("a read that asks for more than there is", long_reads());
    rule("a folder's new name", folders());
    rule("files that lose their names", lost_names());
    return 0;
}
