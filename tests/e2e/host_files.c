/* host_files.c - node 0 uses files as its arguments say, three words a time: what to do, a path, and another
 * path or -. Prints each answer. */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "nx.h"

static long by_calls(const char *how, const char *path, const char *other)
{
    struct stat st;
    char name[200];
    if (!strcmp(how, "stat"))
        return stat(path, &st);
    if (!strcmp(how, "lstat"))
        return lstat(path, &st);
    if (!strcmp(how, "unlink"))
        return unlink(path);
    if (!strcmp(how, "mkdir"))
        return mkdir(path, 0777);
    if (!strcmp(how, "rmdir"))
        return rmdir(path);
    if (!strcmp(how, "chdir"))
        return chdir(path);
    if (!strcmp(how, "rename"))
        return rename(path, other);
    if (!strcmp(how, "excl"))
        return open(path, O_CREAT | O_EXCL | O_WRONLY, 0666);
    if (!strcmp(how, "nofollow"))
        return open(path, O_RDONLY | O_NOFOLLOW);
    if (!strcmp(how, "gopen"))
        return gopen(path, O_RDONLY, 0, 0666);
    if (!strcmp(how, "temporary"))
        return mkstemp(strcpy(name, path)) < 0 ? -1 : unlink(name);
    printf("%s?\n", how);
    return -1;
}

/* Makes a system call past the C library. */
static long call(long number)
{
    long answer;
    __asm__ volatile("syscall" : "=a"(answer) : "a"(number), "D"(0), "S"(0), "d"(0) : "rcx", "r11", "memory");
    return answer;
}

int main(int argc, char **argv)
{
    printf("before, without a newline ");
    if (argc > 1 && !strcmp(argv[1], "syscall"))
        return (int)call(atol(argv[2]));
    for (int i = 1; mynode() == 0 && i + 2 < argc; i += 3) {
        long answer;
        if (!strcmp(argv[i], "r") || !strcmp(argv[i], "w"))
            answer = fopen(argv[i + 1], argv[i]) ? 0 : -1;
        else
            answer = by_calls(argv[i], argv[i + 1], argv[i + 2]);
        printf("%s %s\n", argv[i], answer < 0 ? "fails" : "works");
    }
    return 0;
}
