/* cfs.c - host: tries to open a file of the Concurrent File System. */
#include <errno.h>
#include <stdio.h>

int main(void)
{
    printf("no such file system: %d\n", !fopen("/cfs/x", "w") && errno == ENODEV);
    return 0;
}
