/* pread and pwrite read and write at a place, and leave the file's pointer where it is; asprintf prints to
 * memory of its own. Not of the time: later programs use them.
 * compile: -D_GNU_SOURCE
 * run: -m delta -n 2
 */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "rule.h"

static int at_places(const char *path)
{
    char text[10] = "";
    int fd = open(path, O_RDWR | O_CREAT | O_TRUNC, 0644);
    write(fd, "0123456789", 10);
    lseek(fd, 3, SEEK_SET);
    int right = pwrite(fd, "ab", 2, 5) == 2 && pread(fd, text, 4, 4) == 4 && !memcmp(text, "4ab7", 4) &&
                lseek(fd, 0, SEEK_CUR) == 3 && pread(fd, text, 10, 8) == 2 && pread(fd, text, 1, 20) == 0;
    errno = 0;
    right = right && pread(fd, text, 1, -1) == -1 && errno == EINVAL && lseek(fd, 0, SEEK_CUR) == 3;
    close(fd);
    unlink(path);
    return right;
}

/* What the calls with 64 in their names take has 64 bits: a file with a hole. */
static int far_away(const char *path)
{
    const off64_t far = 5000000000;
    char text[3] = "";
    int fd = open64(path, O_RDWR | O_CREAT | O_TRUNC, 0644);
    int right = pwrite64(fd, "ab", 2, far) == 2 && pread64(fd, text, 2, far) == 2 && !strcmp(text, "ab") &&
                lseek64(fd, 0, SEEK_CUR) == 0 && lseek64(fd, 0, SEEK_END) == far + 2 &&
                ftruncate64(fd, far - 1) == 0 && lseek64(fd, far - 1, SEEK_SET) == far - 1 &&
                read(fd, text, 1) == 0;
    close(fd);
    right = right && truncate64(path, 3000000000) == 0;
    struct stat64 now;
    right = right && stat64(path, &now) == 0 && now.st_size == 3000000000;
    unlink(path);
    return right;
}

int main(void)
{
    char name[30], *text = NULL;
    snprintf(name, sizeof name, "/cfs/places%ld", mynode());
    rule("a file of the machine", at_places(name));
    rule("a file of the computer", at_places(name + 5));
    rule("64 bits, a file of the machine", far_away(name));
    rule("64 bits, a file of the computer", far_away(name + 5));
    rule("asprintf", asprintf(&text, "%s and %1000d", name, 7) == (int)strlen(name) + 1005 &&
                         !strncmp(text, name, strlen(name)) && text[strlen(text) - 1] == '7');
    free(text);
    return 0;
}
