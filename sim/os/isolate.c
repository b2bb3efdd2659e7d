/* isolate.c - see isolate.h. */
#include "os/isolate.h"
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include "node/self.h"

static void protect(char *from, size_t bytes, int how)
{
    if (bytes && mprotect(from, bytes, how)) {
        perror("touchstone: --isolate");
        abort();
    }
}

static void set_writable(const struct node *n, bool writable)
{
    int how = writable ? PROT_READ | PROT_WRITE : PROT_READ;
    char *data = n->guest.data;
    if (n->guest.region->copies_text) { /* code and data have no mappings of their own */
        protect(n->guest.stack, (size_t)(n->guest.program + n->guest.image_bytes - n->guest.stack),
                how | PROT_EXEC);
    } else {
        protect(n->guest.stack, (size_t)(n->guest.program - n->guest.stack),
                n->guest.runs_stack ? how | PROT_EXEC : how);
        protect(data, (size_t)(n->guest.program + n->guest.image_bytes - data), how);
    }
    protect(n->guest.heap_start, n->guest.region->heap_bytes, how);
}

void isolate_made(struct node *n)
{
    if (n->sys->isolate && n->guest.region)
        set_writable(n, false);
}

static void close_writable(struct node_system *s)
{
    if (s->writable && s->writable->guest.region)
        set_writable(s->writable, false);
}

void isolate_run(struct node *n)
{
    struct node_system *s = n->sys;
    if (!s->isolate || s->writable == n)
        return;
    close_writable(s);
    set_writable(n, true);
    s->writable = n;
}

struct node *isolate_keep(struct node_system *s)
{
    struct node *running = s->writable;
    s->writable = NULL;
    return running;
}

void isolate_back_to(struct node_system *s, struct node *caller)
{
    if (s->writable != caller)
        close_writable(s);
    s->writable = caller;
}
