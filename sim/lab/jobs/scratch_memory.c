/* scratch_memory.c - see scratch_memory.h. */
#include "lab/jobs/scratch_memory.h"
#include "kernel/xalloc.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

/* An unlinked file in TMPDIR or /tmp; -1 if none can be made. */
static int nameless_file(void)
{
    const char *tmp = getenv("TMPDIR");
    char *path = xasprintf("%s/touchstone.XXXXXX", tmp && *tmp ? tmp : "/tmp");
    int fd = mkostemp(path, O_CLOEXEC);
    if (fd >= 0)
        unlink(path);
    free(path);
    return fd;
}

void *scratch_memory_new(size_t bytes)
{
    int fd = nameless_file();
    /* The file's blocks are allocated first: a write to a mapped page without room on the disk would end the
     * process. */
    int how = fd >= 0 && posix_fallocate(fd, 0, bytes ? (off_t)bytes : 1) == 0 ? MAP_SHARED
                                                                               : MAP_PRIVATE | MAP_ANONYMOUS;
    void *p = mmap(NULL, bytes ? bytes : 1, PROT_READ | PROT_WRITE, how, how == MAP_SHARED ? fd : -1, 0);
    if (fd >= 0)
        close(fd);
    if (p == MAP_FAILED)
        xexhausted();
    return p;
}

void scratch_memory_free(void *p, size_t bytes)
{
    if (p)
        munmap(p, bytes ? bytes : 1);
}
