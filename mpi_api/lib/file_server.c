/* file_server.c - what the ranks of a file share: the shared pointer, and the lock of atomic mode. Rank 0 has
 * them, and serves all by a handler, which interrupts its program; it asks so, too. All are sent as point to
 * point messages in the context of the file's communicator. */
#include <stdlib.h>
#include "files.h"
#include "nx.h"

enum { ASK = 1, ANSWER = 2 };

struct ask {
    enum { ADD, LOCK, UNLOCK, END } what;
    int call;
    MPI_Offset number;
};

struct file_server {
    struct file *file;
    struct ask ask; /* received */
    bool locked;
    int waits; /* nodes that wait for the lock, the first first */
    long node[];
};

static struct nxm_envelope envelope(const struct file *f, int call, int tag, long node)
{
    return (struct nxm_envelope){call, tag, (int)node, f->comm->context};
}

static void answer(const struct file_server *s, long node, MPI_Offset number)
{
    const struct nxm_envelope e = envelope(s->file, s->ask.call, ANSWER, node);
    nxm_send(&e, &number, sizeof number, false);
}

static void lock(struct file_server *s, long node)
{
    if (s->locked)
        s->node[s->waits++] = node;
    else
        answer(s, node, 0);
    s->locked = true;
}

static void unlock(struct file_server *s)
{
    s->locked = s->waits > 0;
    if (!s->locked)
        return;
    answer(s, s->node[0], 0);
    s->waits--;
    for (int i = 0; i < s->waits; i++)
        s->node[i] = s->node[i + 1];
}

static void add(struct file_server *s, long node)
{
    MPI_Offset before = s->file->shared;
    s->file->shared += s->ask.number;
    answer(s, node, before);
}

static void listen(struct file_server *s);

static void serve(long type, long count, long node, long context, long server)
{
    struct file_server *s = (struct file_server *)server;
    (void)type, (void)count, (void)context;
    if (s->ask.what == END) {
        free(s);
        return;
    }
    if (s->ask.what == ADD)
        add(s, node);
    else if (s->ask.what == LOCK)
        lock(s, node);
    else
        unlock(s);
    listen(s);
}

static void listen(struct file_server *s)
{
    hrecvx(ASK, &s->ask, sizeof s->ask, -1, s->file->comm->context, serve, (long)s);
}

/* --- asking --- */

static void send_ask(const struct file *f, const struct ask *a)
{
    const struct nxm_envelope e = envelope(f, a->call, ASK, group_node(f->comm->local, 0));
    nxm_send(&e, a, sizeof *a, false);
}

static MPI_Offset ask(const struct file *f, const struct ask *a)
{
    MPI_Offset number;
    struct nxm_status status;
    const struct nxm_envelope e = envelope(f, a->call, ANSWER, group_node(f->comm->local, 0));
    send_ask(f, a);
    nxm_recv(&e, &number, sizeof number, &status);
    return number;
}

void server_begin(struct file *f)
{
    int size = f->comm->local->size;
    if (f->comm->local->rank || size == 1)
        return;
    f->server = get_memory(sizeof *f->server + (size_t)size * sizeof f->server->node[0]);
    f->server->file = f, f->server->locked = false, f->server->waits = 0;
    listen(f->server);
}

/* The handler frees the server: nobody else asks any more. */
void server_end(struct file *f)
{
    if (f->server)
        send_ask(f, &(struct ask){END, CALL_File_close, 0});
}

MPI_Offset server_add(struct file *f, int call, MPI_Offset etypes)
{
    if (f->comm->local->size > 1)
        return ask(f, &(struct ask){ADD, call, etypes});
    f->shared += etypes;
    return f->shared - etypes;
}

void server_lock(struct file *f, int call)
{
    if (f->comm->local->size > 1)
        ask(f, &(struct ask){LOCK, call, 0});
}

void server_unlock(struct file *f, int call)
{
    if (f->comm->local->size > 1)
        send_ask(f, &(struct ask){UNLOCK, call, 0});
}
