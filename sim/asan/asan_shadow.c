/* asan_shadow.c - see asan_shadow.h. */
#include "asan/asan_shadow.h"
#include <assert.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>
#include "nx_api/contract/asan.h"

enum {
    GRAIN = NXC_ASAN_GRAIN,
    BEHIND = 8, /* a program looks at up to so many bytes of shadow at once */
    PAGE = 4096,
    OTHERS = 16 << 20, /* of the file of others' shadow: a region takes it eight times */
};

int asan_shadow_others(void)
{
    int fd = memfd_create("shadow", MFD_CLOEXEC);
    if (fd < 0)
        return -1;
    void *all = ftruncate(fd, OTHERS) ? MAP_FAILED : mmap(NULL, OTHERS, PROT_WRITE, MAP_SHARED, fd, 0);
    if (all == MAP_FAILED) {
        close(fd);
        return -1;
    }
    memset(all, NXC_ASAN_OTHERS, OTHERS);
    munmap(all, OTHERS);
    return fd;
}

bool asan_shadow_begin(struct asan_shadow *s, uintptr_t low, size_t bytes, int others)
{
    assert(low % GRAIN == 0 && bytes % GRAIN == 0);
    void *of =
        mmap(NULL, bytes / GRAIN + BEHIND, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (of == MAP_FAILED)
        return false;
    *s = (struct asan_shadow){low, bytes, of};
    for (size_t at = 0, all = bytes / GRAIN; at < all; at += OTHERS)
        if (mmap(s->of + at, all - at < OTHERS ? all - at : OTHERS, PROT_READ, MAP_SHARED | MAP_FIXED, others,
                 0) == MAP_FAILED) {
            asan_shadow_end(s);
            return false;
        }
    return true;
}

void asan_shadow_end(struct asan_shadow *s)
{
    if (s->of)
        munmap(s->of, s->bytes / GRAIN + BEHIND);
    *s = (struct asan_shadow){0};
}

static uint8_t *of(const struct asan_shadow *s, uintptr_t at)
{
    assert(at - s->low < s->bytes);
    return &s->of[(at - s->low) / GRAIN];
}

bool asan_shadow_own(const struct asan_shadow *s, uintptr_t at, size_t bytes)
{
    uint8_t *from = (uint8_t *)((uintptr_t)of(s, at) / PAGE * PAGE);
    size_t all = (size_t)(of(s, at + bytes - 1) + 1 - from);
    return mmap(from, all, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_FIXED,
                -1, 0) != MAP_FAILED;
}

void asan_shadow_mark(const struct asan_shadow *s, uintptr_t at, size_t bytes, uint8_t why)
{
    uintptr_t whole = (at + GRAIN - 1) / GRAIN * GRAIN, end = (at + bytes) / GRAIN * GRAIN;
    if (at + bytes < whole)
        return;
    if (at < whole)
        *of(s, at) = (uint8_t)(at % GRAIN);
    if (whole < end)
        memset(of(s, whole), why, (end - whole) / GRAIN);
}

void asan_shadow_open(const struct asan_shadow *s, uintptr_t at, size_t bytes)
{
    assert(at % GRAIN == 0);
    if (bytes)
        memset(of(s, at), 0, bytes / GRAIN);
    if (bytes % GRAIN)
        *of(s, at + bytes) = (uint8_t)(bytes % GRAIN);
}

void asan_shadow_open_alike(const struct asan_shadow *s, uintptr_t at)
{
    uint8_t *p = of(s, at), why = *p, *end = s->of + s->bytes / GRAIN;
    for (; p < end && *p == why; p++)
        *p = 0;
}

void asan_shadow_forget(const struct asan_shadow *s, uintptr_t at, size_t bytes)
{
    uint8_t *from = of(s, at), *end = from + (bytes + GRAIN - 1) / GRAIN;
    uint8_t *pages = (uint8_t *)(((uintptr_t)from + PAGE - 1) / PAGE * PAGE);
    uint8_t *pages_end = (uint8_t *)((uintptr_t)end / PAGE * PAGE);
    if (pages < pages_end && madvise(pages, (size_t)(pages_end - pages), MADV_DONTNEED) == 0) {
        memset(from, 0, (size_t)(pages - from));
        memset(pages_end, 0, (size_t)(end - pages_end));
    } else {
        memset(from, 0, (size_t)(end - from));
    }
}

/* A byte of shadow from 1 to 7 says how many of its grain's first bytes may be accessed. */
static bool is_open(const struct asan_shadow *s, uintptr_t at)
{
    uint8_t known = *of(s, at);
    return known == 0 || (known < GRAIN && at % GRAIN < known);
}

uintptr_t asan_shadow_first(const struct asan_shadow *s, uintptr_t at, size_t bytes)
{
    for (uintptr_t end = at + bytes; at < end; at = at / GRAIN * GRAIN + GRAIN) {
        if (at - s->low >= s->bytes)
            return 0;
        uintptr_t last = at / GRAIN * GRAIN + GRAIN - 1;
        last = last < end ? last : end - 1;
        if (!is_open(s, last))
            return is_open(s, at) ? at / GRAIN * GRAIN + *of(s, at) : at;
    }
    return 0;
}

uint8_t asan_shadow_why(const struct asan_shadow *s, uintptr_t at)
{
    if (at - s->low >= s->bytes)
        return NXC_ASAN_OTHERS;
    uint8_t known = *of(s, at);
    return known < GRAIN && at + GRAIN - s->low < s->bytes ? *of(s, at + GRAIN) : known;
}
