/* long32_calls.c - the calls whose arguments are passed otherwise where long has 32 bits (nxcc --long32):
 * there an esize_t is one word of 64 bits. */
#include "nx_api/calls/file_calls.h"

#define SIZE_CALL(name, f, end)                                                                              \
    int64_t node_long32_##name(int fd, int64_t offset, int whence) NX_EXPORT_LONG32(#name);                  \
    int64_t node_long32_##name(int fd, int64_t offset, int whence)                                           \
    {                                                                                                        \
        return nx_size_call(#name, f, end, fd, offset, whence);                                              \
    }

SIZE_CALL(eseek, nx_seek, nx_plain)
SIZE_CALL(_eseek, nx_seek, nx_returning)
SIZE_CALL(esize, nx_resize, nx_plain)
SIZE_CALL(_esize, nx_resize, nx_returning)

#define OFFSET_CALL(name, served, buffer, end)                                                               \
    long node_long32_##name(word fd, int64_t offset, buffer buf, size_word len) NX_EXPORT_LONG32(#name);     \
    long node_long32_##name(word fd, int64_t offset, buffer buf, size_word len)                              \
    {                                                                                                        \
        struct node *n = node_self();                                                                        \
        node_enter(n, #name);                                                                                \
        return end(n, served(fd, (word)offset, (word)(offset >> 32), buf, len));                             \
    }
#define OFFSET_CALLS(name, buffer)                                                                           \
    OFFSET_CALL(name, nxs_##name, buffer, nx_plain) OFFSET_CALL(_##name, nxs_##name, buffer, nx_returning)

OFFSET_CALLS(readoff, void *)
OFFSET_CALLS(writeoff, const void *)
OFFSET_CALLS(ireadoff, void *)
OFFSET_CALLS(iwriteoff, const void *)
