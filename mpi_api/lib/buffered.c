/* buffered.c - MPI_Bsend: copies of messages, for which the attached buffer has room. The copies lie in the
 * heap; of the attached buffer only the size counts. */
#include <stdlib.h>
#include <string.h>
#include "lib.h"

struct copy {
    struct copy *next;
    int id;
    size_t bytes;
    char data[];
};

static void *attached;
static size_t size, in_use;
static bool is_attached;
static struct copy *copies;

/* Frees the copies that have left; waits for all if asked to. */
static void settle(int call, bool waits)
{
    for (struct copy **link = &copies, *c; (c = *link);) {
        struct nxm_status s;
        int how = NXM_ALL | (waits ? NXM_WAIT : 0);
        if (!nxm_complete(&(struct nxm_completion){call, how, 1, &c->id, &s})) {
            link = &c->next;
            continue;
        }
        *link = c->next;
        in_use -= c->bytes + MPI_BSEND_OVERHEAD;
        free(c);
    }
}

void buffered_copy(const struct transfer *t)
{
    size_t bytes = (size_t)t->count * size_of(t->type);
    if (t->peer == MPI_PROC_NULL)
        return;
    struct copy *c = get_memory(sizeof *c + bytes);
    type_pack(t->buf, t->count, t->type, c->data);
    c->bytes = bytes;
    struct nxm_envelope e = {t->call, t->tag, group_node(t->c->peers, t->peer), t->c->context};
    c->id = (int)nxm_isend(&e, c->data, (long)bytes, false);
    if (!c->id) {
        free(c);
        return;
    }
    in_use += bytes + MPI_BSEND_OVERHEAD;
    struct copy **last = &copies;
    while (*last)
        last = &(*last)->next;
    c->next = NULL;
    *last = c;
}

int buffered_send(struct transfer *t)
{
    size_t bytes = (size_t)t->count * size_of(t->type);
    if (t->peer == MPI_PROC_NULL)
        return MPI_SUCCESS;
    settle(t->call, false);
    if (in_use + bytes + MPI_BSEND_OVERHEAD > size)
        return fail(
            t->c, t->call, MPI_ERR_BUFFER,
            "%zu bytes and MPI_BSEND_OVERHEAD do not fit into the attached buffer: %zu of %zu are free",
            bytes, size - in_use, size);
    buffered_copy(t);
    return MPI_SUCCESS;
}

CALL(Buffer_attach, (void *buf, int bytes))
{
    if (is_attached)
        return fail(NULL, CALL_Buffer_attach, MPI_ERR_BUFFER, "a buffer is attached already");
    if (bytes < 0)
        return fail(NULL, CALL_Buffer_attach, MPI_ERR_ARG, "%d bytes", bytes);
    attached = buf, size = (size_t)bytes, is_attached = true;
    return MPI_SUCCESS;
}

CALL(Buffer_detach, (void *buf, int *bytes))
{
    settle(CALL_Buffer_detach, true);
    memcpy(buf, &attached, sizeof attached);
    *bytes = (int)size;
    attached = NULL, size = 0, is_attached = false;
    return MPI_SUCCESS;
}
