/* transfer.c - cread, cwrite, iread, iwrite and their forms with several parts: all are one of two movements of parts
 * between memory and a file, which the backend makes. */
#include "nx_api/calls/call.h"

/* A buffer as a part. Lengths are the machine's: 32 bits. */
static struct iovec whole(const void *buf, size_word len)
{
    return (struct iovec){(void *)(uintptr_t)buf, (uint32_t)len};
}

long nxs_cread(word fd, void *buf, size_word len)
{
    struct iovec part = whole(buf, len);
    return nx_move(false, fd, &part, 1);
}

long nxs_creadv(word fd, const struct iovec *parts, word count)
{
    return nx_move(false, fd, parts, count);
}

long nxs_cwrite(word fd, const void *buf, size_word len)
{
    struct iovec part = whole(buf, len);
    return nx_move(true, fd, &part, 1);
}

long nxs_cwritev(word fd, const struct iovec *parts, word count)
{
    return nx_move(true, fd, parts, count);
}

long nxs_iread(word fd, void *buf, size_word len)
{
    struct iovec part = whole(buf, len);
    return nx_move_later(false, fd, &part, 1);
}

long nxs_ireadv(word fd, const struct iovec *parts, word count)
{
    return nx_move_later(false, fd, parts, count);
}

long nxs_iwrite(word fd, const void *buf, size_word len)
{
    struct iovec part = whole(buf, len);
    return nx_move_later(true, fd, &part, 1);
}

long nxs_iwritev(word fd, const struct iovec *parts, word count)
{
    return nx_move_later(true, fd, parts, count);
}
