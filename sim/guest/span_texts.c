/* span_texts.c - see span_texts.h. */
#include "guest/span_texts.h"
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>
#include "kernel/xalloc.h"

struct text {
    const struct node_image *img; /* NULL: the span has none yet */
    size_t offset;
};

struct span_texts {
    int fd;
    uint32_t spans, shift;
    struct text of[]; /* by span */
};

struct span_texts *span_texts_new(uint32_t spans, uint32_t shift)
{
    int fd = memfd_create("texts", MFD_CLOEXEC);
    if (fd < 0)
        return NULL;
    if (ftruncate(fd, (off_t)spans << shift)) {
        close(fd);
        return NULL;
    }
    struct span_texts *t = xcalloc(1, sizeof *t + spans * sizeof *t->of);
    t->fd = fd, t->spans = spans, t->shift = shift;
    return t;
}

void span_texts_free(struct span_texts *t)
{
    if (!t)
        return;
    close(t->fd);
    free(t);
}

bool span_texts_fit(const struct span_texts *t, uint32_t spans, uint32_t shift)
{
    return t->spans == spans && t->shift == shift;
}

bool span_texts_map(const struct span_texts *t, char *there, size_t offset, size_t bytes)
{
    return mmap(there, bytes, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_NORESERVE | MAP_FIXED,
                t->fd, (off_t)offset) != MAP_FAILED;
}

enum node_text span_texts_claim(struct span_texts *t, const struct node_image *img, size_t offset)
{
    struct text *x = &t->of[offset >> t->shift];
    if (x->img)
        return x->img == img && x->offset == offset ? TEXT_SHARED : TEXT_OWN;
    *x = (struct text){img, offset};
    return TEXT_TO_SHARE;
}

bool span_texts_write(const struct span_texts *t, size_t offset, const void *text, size_t bytes)
{
    return pwrite(t->fd, text, bytes, (off_t)offset) == (ssize_t)bytes;
}
