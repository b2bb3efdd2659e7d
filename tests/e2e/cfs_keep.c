/* Writes a line into a file of /cfs ("write"), or prints what it finds there ("read"); opens, or makes, the
 * file of a name ("try"), or moves and removes it ("remove"); anything else is a name to open. */
#include <errno.h>
#include <fcntl.h>
#include <nx.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *result(int answer)
{
    return strerror(answer < 0 ? errno : 0);
}

static void try(const char *name)
{
    struct stat st;
    printf("open: %s; ", result(open(name, O_RDWR | O_CREAT, 0644)));
    printf("stat: %s\n", result(stat(name, &st)));
}

static void move_and_remove(const char *name)
{
    int moved = rename(name, "/cfs/moved");
    printf("rename: %s; ", result(moved));
    printf("unlink: %s\n", result(unlink(moved ? name : "/cfs/moved")));
}

int main(int argc, char **argv)
{
    char line[64] = {0};
    int fd;
    if (argc == 2 && strcmp(argv[1], "write") == 0) {
        fd = gopen("/cfs/kept/lines", O_RDWR | O_CREAT, M_RECORD, 0644);
        sprintf(line, "node %ld of %ld\n", mynode(), numnodes());
        cwrite(fd, line, 16);
    } else if (argc == 2 && strcmp(argv[1], "read") == 0) {
        fd = gopen("/cfs/kept/lines", O_RDONLY, M_SYNC, 0);
        write(1, line, cread(fd, line, 16));
    } else if (argc == 3 && strcmp(argv[1], "try") == 0) {
        try(argv[2]);
    } else if (argc == 3 && strcmp(argv[1], "remove") == 0) {
        move_and_remove(argv[2]);
    } else {
        gopen(argv[1], O_RDONLY, M_UNIX, 0);
    }
    return 0;
}
