/* stripe.h - the division of a file's range into blocks on disks: block b is on the file's disk b mod n, in
 * row b / n.
 *
 *   block   0    1    2    3    4    5    6      of a file on disks 0, 1, 2
 *   disk    0    1    2    0    1    2    0
 *   row     0    0    0    1    1    1    2
 */
#ifndef CFS_STRIPE_H
#define CFS_STRIPE_H
#include <stdint.h>

struct stripe {
    uint64_t block, row;
    uint32_t disk;
    uint32_t offset, bytes; /* within the block */
};

/* The first piece of a range of `left` bytes at `at`. volumes: the file's disks in order; NULL: 0, 1, ... */
static inline struct stripe stripe_first(const uint32_t *volumes, uint32_t volume_count, uint32_t block_bytes,
                                         uint64_t at, uint64_t left)
{
    struct stripe s = {.block = at / block_bytes, .offset = (uint32_t)(at % block_bytes)};
    uint32_t which = (uint32_t)(s.block % volume_count), room = block_bytes - s.offset;
    s.row = s.block / volume_count;
    s.disk = volumes ? volumes[which] : which;
    s.bytes = left < room ? (uint32_t)left : room;
    return s;
}
#endif
