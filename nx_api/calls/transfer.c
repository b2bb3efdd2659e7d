/* transfer.c - cread, cwrite, iread, iwrite, their forms with several parts, and their forms with an offset:
 * each is one of the back end's two ways of moving parts between memory and a file. */
#include <errno.h>
#include "nx_api/calls/call.h"

/* A buffer as one part. Lengths have 32 bits, as on the machine. */
static struct iovec whole(const void *buf, size_word len)
{
    return (struct iovec){(void *)(uintptr_t)buf, (uint32_t)len};
}

long nxs_cread(word fd, void *buf, size_word len)
{
    struct iovec part = whole(buf, len);
    return nx_move(false, fd, AT_POINTER, &part, 1);
}

long nxs_creadv(word fd, const struct iovec *parts, word count)
{
    return nx_move(false, fd, AT_POINTER, parts, count);
}

long nxs_cwrite(word fd, const void *buf, size_word len)
{
    struct iovec part = whole(buf, len);
    return nx_move(true, fd, AT_POINTER, &part, 1);
}

long nxs_cwritev(word fd, const struct iovec *parts, word count)
{
    return nx_move(true, fd, AT_POINTER, parts, count);
}

long nxs_iread(word fd, void *buf, size_word len)
{
    struct iovec part = whole(buf, len);
    return nx_move_later(false, fd, AT_POINTER, &part, 1);
}

long nxs_ireadv(word fd, const struct iovec *parts, word count)
{
    return nx_move_later(false, fd, AT_POINTER, parts, count);
}

long nxs_iwrite(word fd, const void *buf, size_word len)
{
    struct iovec part = whole(buf, len);
    return nx_move_later(true, fd, AT_POINTER, &part, 1);
}

long nxs_iwritev(word fd, const struct iovec *parts, word count)
{
    return nx_move_later(true, fd, AT_POINTER, parts, count);
}

/* --- at an offset, not at the file's pointer --- */

typedef long movement(bool write, int fd, int64_t at, const struct iovec *parts, int count);

static long move_at(movement *move, bool write, word fd, word slow, word shigh, const void *buf,
                    size_word len)
{
    struct iovec part = whole(buf, len);
    if (shigh < 0)
        return node_error(node_self(), EINVAL, "the offset is negative");
    return move(write, fd, (int64_t)shigh << 32 | (uint32_t)slow, &part, 1);
}

long nxs_readoff(word fd, word slow, word shigh, void *buf, size_word len)
{
    return move_at(nx_move, false, fd, slow, shigh, buf, len);
}

long nxs_writeoff(word fd, word slow, word shigh, const void *buf, size_word len)
{
    return move_at(nx_move, true, fd, slow, shigh, buf, len);
}

long nxs_ireadoff(word fd, word slow, word shigh, void *buf, size_word len)
{
    return move_at(nx_move_later, false, fd, slow, shigh, buf, len);
}

long nxs_iwriteoff(word fd, word slow, word shigh, const void *buf, size_word len)
{
    return move_at(nx_move_later, true, fd, slow, shigh, buf, len);
}
