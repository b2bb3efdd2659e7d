/* transfer.c - reading and writing: at once or begun, of one buffer, of several parts, or at an offset. Each
 * call is one of the back end's two ways of moving parts between memory and a file. */
#include <errno.h>
#include "nx_api/calls/call.h"

typedef long movement(bool write, int fd, int64_t at, const struct iovec *parts, int count);

/* Lengths have 32 bits, as on the machine. */
static long move_one(movement *move, bool write, word fd, int64_t at, const void *buf, size_word len)
{
    const struct iovec part = {(void *)(uintptr_t)buf, len};
    return move(write, fd, at, &part, 1);
}

static long move_at(movement *move, bool write, word fd, word slow, word shigh, const void *buf,
                    size_word len)
{
    if (shigh < 0)
        return node_error(node_self(), EINVAL, "the offset is negative");
    return move_one(move, write, fd, (int64_t)shigh << 32 | (uint32_t)slow, buf, len);
}

#define TRANSFERS(one, several, at_offset, move, write, buffer)                                              \
    long nxs_##one(word fd, buffer buf, size_word len)                                                       \
    {                                                                                                        \
        return move_one(move, write, fd, AT_POINTER, buf, len);                                              \
    }                                                                                                        \
    long nxs_##several(word fd, const struct iovec *parts, word count)                                       \
    {                                                                                                        \
        return move(write, fd, AT_POINTER, parts, count);                                                    \
    }                                                                                                        \
    long nxs_##at_offset(word fd, word slow, word shigh, buffer buf, size_word len)                          \
    {                                                                                                        \
        return move_at(move, write, fd, slow, shigh, buf, len);                                              \
    }

TRANSFERS(cread, creadv, readoff, nx_move, false, void *)
TRANSFERS(cwrite, cwritev, writeoff, nx_move, true, const void *)
TRANSFERS(iread, ireadv, ireadoff, nx_move_later, false, void *)
TRANSFERS(iwrite, iwritev, iwriteoff, nx_move_later, true, const void *)
