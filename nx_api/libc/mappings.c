/* mappings.c - files mapped into memory: each mapping is a block of the node's heap, into which the file is
 * read when it is made. So what is written into a mapping stays in it, and a mapping by which a file would be
 * changed (MAP_SHARED that may be written) is not there. */
#define _GNU_SOURCE
#include <errno.h>
#include <malloc.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

struct mapping {
    char *at;
    size_t bytes;
    struct mapping *next;
};

static struct mapping *all;

static void *fail(int why)
{
    errno = why;
    return MAP_FAILED;
}

/* Reads what the file has; behind its end are zeros. */
static int fill(char *to, size_t bytes, int fd, off_t place)
{
    for (size_t done = 0; done < bytes;) {
        ssize_t n = pread64(fd, to + done, bytes - done, place + (off_t)done);
        if (n < 0)
            return -1;
        if (n == 0)
            break;
        done += (size_t)n;
    }
    return 0;
}

void *mmap(void *at, size_t bytes, int access, int flags, int fd, off_t place)
{
    size_t page = (size_t)getpagesize();
    int of_file = !(flags & MAP_ANONYMOUS);
    (void)at;
    if (!bytes || (size_t)place % page || !(flags & (MAP_SHARED | MAP_PRIVATE)))
        return fail(EINVAL);
    if (flags & MAP_FIXED || (of_file && flags & MAP_SHARED && access & PROT_WRITE))
        return fail(ENODEV);
    bytes = (bytes + page - 1) / page * page; /* 0: more than there are addresses */
    struct mapping *m = bytes ? malloc(sizeof *m) : NULL;
    char *p = m ? memalign(page, bytes) : NULL;
    if (!p) {
        free(m);
        return fail(ENOMEM);
    }
    memset(p, 0, bytes);
    if (of_file && fill(p, bytes, fd, place) < 0) {
        int why = errno;
        free(p);
        free(m);
        return fail(why);
    }
    *m = (struct mapping){p, bytes, all};
    all = m;
    return p;
}

/* A mapping goes as a whole. */
int munmap(void *at, size_t bytes)
{
    size_t page = (size_t)getpagesize();
    for (struct mapping **link = &all; *link; link = &(*link)->next) {
        struct mapping *m = *link;
        if (m->at != at || m->bytes != (bytes + page - 1) / page * page)
            continue;
        *link = m->next;
        free(m->at);
        free(m);
        return 0;
    }
    errno = EINVAL;
    return -1;
}

/* Advice, and what a node's memory is always: it may be written, and is present. */
int mprotect(void *at, size_t bytes, int access)
{
    (void)at, (void)bytes, (void)access;
    return 0;
}

int msync(void *at, size_t bytes, int flags)
{
    (void)at, (void)bytes, (void)flags;
    return 0;
}

int madvise(void *at, size_t bytes, int advice)
{
    (void)at, (void)bytes, (void)advice;
    return 0;
}

int mlock(const void *at, size_t bytes)
{
    (void)at, (void)bytes;
    return 0;
}

int munlock(const void *at, size_t bytes)
{
    return mlock(at, bytes);
}

/* By the name of headers with -D_FILE_OFFSET_BITS=64. */
__asm__(".globl mmap64\n.set mmap64, mmap");
