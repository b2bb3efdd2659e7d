/* order_record.c - see order_record.h. */
#include "nx_api/mpi/order_record.h"
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>
#include "nx_api/mpi/mpi_wire.h"

enum { NOBODY = -1 };

struct match {
    int64_t from; /* NOBODY: the receive has got no message, or has been withdrawn */
    uint64_t nth; /* of those that `from` has sent to this node */
};

static struct {
    char *path; /* NULL: nothing is recorded */
    long node;
    uint32_t nodes;
    struct match *matches; /* by receive */
    uint64_t receives, most_receives;
    uint64_t *handlers; /* calls begun before each */
    uint64_t handler_count, most_handlers;
    uint64_t *arrived; /* messages, by sender */
    FILE *file;        /* on node 0: NULL until the first part comes */
} all;

bool order_recorded;
uint64_t order_calls;

static void *must(void *p)
{
    if (!p)
        node_fail(node_self(), "NX_RECORD: out of memory");
    return p;
}

void record_begin(struct node *n)
{
    char path[PATH_MAX] = "";
    const char *asked = getenv("NX_RECORD");
    if (n->id == 0 && asked && *asked && strlen(asked) >= sizeof path - 20)
        node_fail(n, "NX_RECORD: the path is too long");
    if (n->id == 0 && asked)
        strcpy(path, asked);
    wire_share(path, sizeof path);
    if (!*path)
        return;
    all.path = must(strdup(path));
    order_recorded = true;
    all.node = n->id, all.nodes = n->sys->count;
    all.arrived = must(calloc(all.nodes, sizeof *all.arrived));
}

void record_arrival(struct message *m)
{
    m->nth = all.arrived[m->source]++;
}

static void *with_room(void *array, uint64_t count, uint64_t *most, size_t bytes)
{
    if (count < *most)
        return array;
    *most = 2 * *most + 1024;
    return must(reallocarray(array, *most, bytes));
}

void record_receive(struct receive *r)
{
    r->number = all.receives;
    all.matches = with_room(all.matches, all.receives, &all.most_receives, sizeof *all.matches);
    all.matches[all.receives++].from = NOBODY;
}

void record_match(const struct receive *r, const struct message *m)
{
    all.matches[r->number] = (struct match){m->source, m->nth};
}

void record_withdraw(const struct receive *r)
{
    all.matches[r->number].from = NOBODY;
}

void record_handler(void)
{
    all.handlers = with_room(all.handlers, all.handler_count, &all.most_handlers, sizeof *all.handlers);
    all.handlers[all.handler_count++] = order_calls;
}

/* --- the parts --- */

/* Text that is written with functions that are safe in a signal handler: so neither printf is used, nor open,
 * write and close, which are libnx.a's own. */
struct out {
    char bytes[4096];
    size_t count;
    void (*write)(struct out *o); /* writes the bytes away */
    FILE *f;
    int fd;
};

static void flush(struct out *o)
{
    o->write(o);
    o->count = 0;
}

static void put_text(struct out *o, const char *s)
{
    size_t length = strlen(s);
    if (o->count + length > sizeof o->bytes)
        flush(o);
    memcpy(o->bytes + o->count, s, length);
    o->count += length;
}

static void put_number(struct out *o, uint64_t number)
{
    char digits[24], *p = digits + sizeof digits - 1;
    *p = '\0';
    do
        *--p = (char)('0' + number % 10);
    while ((number /= 10) > 0);
    put_text(o, " ");
    put_text(o, p);
}

static void put_match(struct out *o, uint64_t k)
{
    put_text(o, "match");
    put_number(o, (uint64_t)all.node);
    put_number(o, k);
    put_number(o, (uint64_t)all.matches[k].from);
    put_number(o, all.matches[k].nth);
    put_text(o, "\n");
}

static void put_handler(struct out *o, uint64_t k)
{
    put_text(o, "handler");
    put_number(o, (uint64_t)all.node);
    put_number(o, k);
    put_number(o, all.handlers[k]);
    put_text(o, "\n");
}

static void put_head(struct out *o)
{
    put_text(o, "touchstone-schedule 1\nnodes");
    put_number(o, all.nodes);
    put_text(o, "\norders\n");
    flush(o);
}

static void put_part(struct out *o)
{
    for (uint64_t k = 0; k < all.receives; k++)
        if (all.matches[k].from != NOBODY)
            put_match(o, k);
    for (uint64_t k = 0; k < all.handler_count; k++)
        put_handler(o, k);
    flush(o);
}

static void to_stream(struct out *o)
{
    fwrite(o->bytes, 1, o->count, o->f);
}

static void to_file(struct out *o)
{
    for (size_t at = 0; at < o->count;) {
        ssize_t done = syscall(SYS_write, o->fd, o->bytes + at, o->count - at);
        if (done <= 0)
            return;
        at += (size_t)done;
    }
}

/* --- brought together --- */

/* So much of a text as one message is to have: whole lines. */
static size_t piece(const char *text, size_t size)
{
    enum { MOST = 1 << 26 };
    size_t end = MOST;
    if (size <= MOST)
        return size;
    while (text[end - 1] != '\n')
        end--;
    return end;
}

void record_end(struct node *n)
{
    char *text = NULL;
    size_t size = 0;
    if (!all.path)
        return;
    struct out o = {.write = to_stream, .f = must(open_memstream(&text, &size))};
    put_part(&o);
    fclose(o.f);
    for (size_t at = 0, bytes; at < size; at += bytes) {
        bytes = piece(text + at, size - at);
        wire_send(n, 0, (struct wire_head){.kind = WIRE_RECORD}, text + at, bytes);
    }
    free(text);
}

static void begin_file(void)
{
    all.file = fopen(all.path, "w");
    struct out o = {.write = to_stream, .f = all.file};
    if (all.file)
        put_head(&o);
}

void record_part(const void *bytes, size_t count)
{
    static bool failed;
    if (!all.file && !failed)
        begin_file();
    if (!failed && (!all.file || fwrite(bytes, 1, count, all.file) != count || fflush(all.file) != 0)) {
        failed = true;
        fprintf(stderr, "nx: NX_RECORD: %s cannot be written: %s%s\n", all.path, strerror(errno),
                all.file ? "; what is in it is not complete" : "");
    }
}

void record_rescue(void)
{
    static bool begun;
    struct out o = {.write = to_file}, path = {.count = 0};
    if (!all.path || begun)
        return;
    begun = true;
    put_text(&path, all.path);
    put_number(&path, (uint64_t)all.node);
    path.bytes[path.count] = '\0';
    *strrchr(path.bytes, ' ') = '.';
    o.fd = openat(AT_FDCWD, path.bytes, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (o.fd < 0)
        return;
    if (all.node == 0)
        put_head(&o);
    put_part(&o);
    syscall(SYS_close, o.fd);
}
