/* POSIX's calls on descriptors and names of files, on files of the computer: lengths, places, errors,
 * temporary names.
 * compile: -D_GNU_SOURCE
 * again: -D_FILE_OFFSET_BITS=64
 * run: -m ipsc860 -n 3
 * run: -m paragon -n 1
 */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>
#include "rule.h"

static char name[60], other[60], cfs_name[60], cfs_other[60];

static int fails(long answer, int error)
{
    int is = answer == -1 && errno == error;
    errno = 0;
    return is;
}

static long length_of(int fd)
{
    struct stat st;
    return fstat(fd, &st) == 0 && S_ISREG(st.st_mode) ? (long)st.st_size : -1;
}

static int numbers(void)
{
    int a = creat(name, 0600), b = open(name, O_RDONLY), c = open(name, O_RDONLY), again;
    int holds = a > 2 && a < b && b < c && close(b) == 0;
    again = open(name, O_RDONLY);
    return holds && again == b && close(a) == 0 && close(again) == 0 && close(c) == 0;
}

static int closed(void)
{
    char byte;
    struct stat st;
    int fd = creat(name, 0600);
    return close(fd) == 0 && fails(close(fd), EBADF) && fails(read(fd, &byte, 1), EBADF) &&
           fails(write(fd, "x", 1), EBADF) && fails(lseek(fd, 0, SEEK_SET), EBADF) &&
           fails(fstat(fd, &st), EBADF) && fails(ftruncate(fd, 0), EBADF) && fails(fsync(fd), EBADF) &&
           fails(isatty(fd) - 1, EBADF) && fails(close(-1), EBADF) && fails(close(100000), EBADF);
}

static int one_way(void)
{
    char byte;
    int out = creat(name, 0600), in = open(name, O_RDONLY);
    return fails(read(out, &byte, 1), EBADF) && fails(write(in, "x", 1), EBADF) &&
           fails(ftruncate(in, 0), EINVAL) && close(in) == 0 && close(out) == 0;
}

static int in_parts(void)
{
    char text[20] = "";
    struct iovec parts[] = {{"one ", 4}, {NULL, 0}, {"two ", 4}, {"three", 5}};
    int fd = open(name, O_RDWR | O_CREAT | O_TRUNC, 0600);
    return writev(fd, parts, 4) == 13 && lseek(fd, 0, SEEK_CUR) == 13 && writev(fd, parts, 0) == 0 &&
           lseek(fd, 0, SEEK_SET) == 0 && read(fd, text, 20) == 13 && !strcmp(text, "one two three") &&
           close(fd) == 0 && fails(writev(fd, parts, 4), EBADF);
}

static int lengths(void)
{
    char text[8] = "1234567";
    int fd = open(name, O_RDWR | O_CREAT | O_TRUNC, 0600);
    int holds = write(fd, "abcdef", 6) == 6 && ftruncate(fd, 2) == 0 && length_of(fd) == 2;
    holds = holds && lseek(fd, 0, SEEK_CUR) == 6 && ftruncate(fd, 5) == 0 && length_of(fd) == 5;
    holds =
        holds && lseek(fd, 0, SEEK_SET) == 0 && read(fd, text, 8) == 5 && memcmp(text, "ab\0\0\0", 5) == 0;
    holds = holds && lseek(fd, 10, SEEK_SET) == 10 && write(fd, "x", 1) == 1 && length_of(fd) == 11;
    return holds && fails(lseek(fd, -12, SEEK_END), EINVAL) && fails(ftruncate(fd, -1), EINVAL) &&
           lseek(fd, 0, SEEK_CUR) == 11 && fsync(fd) == 0 && close(fd) == 0;
}

static int at_the_end(void)
{
    int a = open(name, O_WRONLY | O_CREAT | O_TRUNC, 0600), b = open(name, O_WRONLY | O_APPEND);
    return write(a, "first", 5) == 5 && write(b, "second", 6) == 6 && length_of(a) == 11 &&
           write(a, "!", 1) == 1 && length_of(a) == 11 && close(a) == 0 && close(b) == 0;
}

static int no_terminal(void)
{
    char text[40];
    int fd = creat(name, 0600);
    errno = 0;
    return isatty(fd) == 0 && errno == ENOTTY && ttyname_r(fd, text, sizeof text) == ENOTTY && close(fd) == 0;
}

/* Duplicates are one open file, with one place in it; the file stays open as long as one of them does. */
static int duplicates(const char *name, const char *other)
{
    char text[8] = "";
    int fd = open(name, O_RDWR | O_CREAT | O_TRUNC, 0600), second = dup(fd), far = dup2(fd, 40);
    int holds = second > fd && far == 40 && write(fd, "abc", 3) == 3 && write(second, "def", 3) == 3;
    holds = holds && close(fd) == 0 && fails(write(fd, "x", 1), EBADF) && lseek(far, 0, SEEK_CUR) == 6;
    holds = holds && lseek(second, 2, SEEK_SET) == 2 && read(far, text, 8) == 4 && !strcmp(text, "cdef");
    holds = holds && dup2(far, far) == far && fcntl(far, F_DUPFD, 30) == 30 && close(30) == 0;
    holds = holds && fails(dup(fd), EBADF) && fails(dup2(fd, far), EBADF) && fails(dup2(far, -1), EBADF);
    /* dup2 closes what was there */
    int other_file = creat(other, 0600);
    holds = holds && dup2(other_file, far) == far && write(far, "12", 2) == 2 && length_of(second) == 6;
    return holds && length_of(other_file) == 2 && close(far) == 0 && close(second) == 0 &&
           close(other_file) == 0 && unlink(other) == 0;
}

/* NX's calls take a duplicate as they take the file. */
static int of_the_cfs(void)
{
    int fd = creat(cfs_name, 0600), second = dup(fd), third = dup2(fd, 50);
    return close(fd) == 0 && lsize(second, 100, SIZE_SET) >= 100 && lsize(third, 0, SIZE_END) >= 100 &&
           cwrite(third, "x", 1) == 1 && close(second) == 0 && close(third) == 0 && unlink(cfs_name) == 0;
}

/* A stream of a descriptor, and the descriptor of a stream. */
static int streams(void)
{
    char text[20] = "";
    FILE *f = fopen(name, "w+"), *of;
    int fd = f ? fileno(f) : -1;
    int holds = fd > 2 && fprintf(f, "one ") == 4 && fflush(f) == 0 && write(fd, "two ", 4) == 4;
    holds = holds && (of = fdopen(dup(fd), "a")) && fileno(of) != fd && fprintf(of, "three") == 5;
    holds = holds && fclose(of) == 0 && lseek(fd, 0, SEEK_SET) == 0 && read(fd, text, 19) == 13;
    holds = holds && !strcmp(text, "one two three") && fclose(f) == 0 && fails(close(fd), EBADF);
    errno = 0;
    return holds && !fdopen(fd, "r") && errno == EBADF;
}

/* The standard streams follow their descriptors, to files and back. */
static int redirected(void)
{
    char word[20] = "", line[20] = "";
    int in = dup(0), out = dup(1), terminal = isatty(1), fd = open(name, O_RDWR | O_CREAT | O_TRUNC, 0600);
    fflush(stdout);
    int holds = dup2(fd, 1) == 1 && !isatty(1) && isatty(out) == terminal;
    printf("by stdout\n");
    fflush(stdout);
    holds = holds && write(1, "by write\n", 9) == 9 && lseek(fd, 0, SEEK_CUR) == 19;
    holds = holds && dup2(out, 1) == 1 && isatty(1) == terminal && close(out) == 0 && close(fd) == 0;
    /* 0 is the least that is free */
    holds = holds && close(0) == 0 && open(name, O_RDONLY) == 0 && scanf("by %s ", word) == 1;
    holds =
        holds && !strcmp(word, "stdout") && fgets(line, sizeof line, stdin) && !strcmp(line, "by write\n");
    return holds && dup2(in, 0) == 0 && close(in) == 0 && !isatty(in) && unlink(name) == 0;
}

static int temporary_names(void)
{
    char a[60], b[60], c[60], wrong[60] = "descriptors.XXXXX";
    struct stat st;
    snprintf(a, sizeof a, "descriptors.%ld.XXXXXX", mynode());
    strcpy(b, a), strcpy(c, a);
    int fd = mkstemp(a), second = mkostemp(b, O_APPEND);
    int holds = fd > 2 && second > fd && strcmp(a, b) != 0 && strlen(a) == strlen(c) && !strstr(a, "XXXXXX");
    holds = holds && fstat(fd, &st) == 0 && (st.st_mode & 07777) == 0600 && st.st_size == 0;
    holds = holds && write(fd, "abc", 3) == 3 && lseek(fd, 0, SEEK_SET) == 0 && read(fd, c + 20, 1) == 1;
    holds = holds && fails(mkstemp(wrong), EINVAL) && !strcmp(wrong, "descriptors.XXXXX");
    return holds && close(fd) == 0 && close(second) == 0 && unlink(a) == 0 && unlink(b) == 0;
}

static int a_name_of_no_file(void)
{
    char a[60], wrong[] = "XXXXX";
    snprintf(a, sizeof a, "descriptors.%ld.XXXXXX", mynode());
    return mktemp(a) == a && *a && fails(access(a, F_OK), ENOENT) && *mktemp(wrong) == 0;
}

static int names(void)
{
    struct stat st;
    int fd = open(name, O_RDWR | O_CREAT | O_TRUNC, 0600);
    int holds = write(fd, "kept", 4) == 4 && close(creat(other, 0600)) == 0 && access(other, F_OK) == 0;
    holds = holds && rename(name, other) == 0 && fails(access(name, F_OK), ENOENT);
    holds = holds && stat(other, &st) == 0 && st.st_size == 4 && fails(rename(name, other), ENOENT);
    holds = holds && fails(open(other, O_WRONLY | O_CREAT | O_EXCL, 0600), EEXIST) && remove(other) == 0;
    return holds && length_of(fd) == 4 && fails(unlink(other), ENOENT) && close(fd) == 0;
}

static int folders(void)
{
    char inside[80];
    struct stat st;
    snprintf(inside, sizeof inside, "%s/file", other);
    int holds =
        mkdir(other, 0700) == 0 && fails(mkdir(other, 0700), EEXIST) && close(creat(inside, 0600)) == 0;
    holds = holds && lstat(other, &st) == 0 && S_ISDIR(st.st_mode) && fails(rmdir(other), ENOTEMPTY);
    holds = holds && fails(open(other, O_WRONLY), EISDIR) && unlink(inside) == 0 && remove(other) == 0;
    return holds && fails(rmdir(other), ENOENT);
}

static int flags(const char *path)
{
    int fd = open(path, O_RDWR | O_CREAT | O_APPEND, 0600), reading = open(path, O_RDONLY), copy = dup(fd);
    int good = (fcntl(fd, F_GETFL) & O_ACCMODE) == O_RDWR && fcntl(fd, F_GETFL) & O_APPEND;
    good = good && (fcntl(reading, F_GETFL) & (O_ACCMODE | O_APPEND | O_NONBLOCK)) == O_RDONLY;
    good = good && fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) | O_NONBLOCK) == 0;
    good = good && (fcntl(copy, F_GETFL) & (O_APPEND | O_NONBLOCK)) == (O_APPEND | O_NONBLOCK);
    good =
        good && close(fd) == 0 && close(copy) == 0 && close(reading) == 0 && fails(fcntl(fd, F_GETFL), EBADF);
    return unlink(path) == 0 && good;
}

int main(void)
{
    snprintf(name, sizeof name, "descriptors.tmp%ld", mynode());
    snprintf(other, sizeof other, "descriptors.other%ld", mynode());
    snprintf(cfs_name, sizeof cfs_name, "/cfs/%s", name);
    snprintf(cfs_other, sizeof cfs_other, "/cfs/%s", other);
    rule("a closed file's number is given again, the least first", numbers());
    rule("a closed file is none", closed());
    rule("files for reading, files for writing", one_way());
    rule("writev", in_parts());
    rule("lengths and places", lengths());
    rule("O_APPEND", at_the_end());
    rule("a file is no terminal", no_terminal());
    rule("duplicates", duplicates(name, other));
    rule("duplicates of files of the CFS", duplicates(cfs_name, cfs_other) && of_the_cfs());
    rule("flags, which duplicates share", flags(other) && flags(cfs_other));
    rule("streams of descriptors", streams());
    rule("standard streams follow their descriptors", redirected());
    rule("temporary files", temporary_names());
    rule("a name of no file", a_name_of_no_file());
    rule("files lose their names", names());
    rule("folders", folders());
    unlink(name);
    return 0;
}
