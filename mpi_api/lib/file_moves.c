/* file_moves.c - reading and writing files. */
#include <errno.h>
#include <stdlib.h>
#include "files.h"

/* A read or write of a range of the view. */
struct move {
    struct file *f;
    int call;
    bool write;
    MPI_Offset at; /* in etypes */
    void *buf;
    int count;
    MPI_Datatype type;
};

static size_t bytes_of(const struct move *m)
{
    return (size_t)m->count * size_of(m->type);
}

static int check(const struct move *m)
{
    struct file *f = m->f;
    size_t etype = size_of(f->etype);
    if (m->count < 0)
        return fail_file(f, m->call, MPI_ERR_COUNT, "the count %d is negative", m->count);
    if (!type_is_valid(m->type))
        return fail_file(f, m->call, MPI_ERR_TYPE, "the datatype is null, freed, or not committed");
    if (m->write && f->amode & MPI_MODE_RDONLY)
        return fail_file(f, m->call, MPI_ERR_READ_ONLY, "%s is open for reading only", f->name);
    if (!m->write && f->amode & MPI_MODE_WRONLY)
        return fail_file(f, m->call, MPI_ERR_ACCESS, "%s is open for writing only", f->name);
    if (bytes_of(m) && (!etype || bytes_of(m) % etype))
        return fail_file(f, m->call, MPI_ERR_IO, "%zu bytes are no whole number of etypes of %zu bytes",
                         bytes_of(m), etype);
    return MPI_SUCCESS;
}

/* --- the data, together in memory --- */

/* Where they lie; *packed: memory of their own, to be freed. */
static char *data_of(const struct move *m, char **packed)
{
    size_t bytes;
    char *at = m->f->external ? NULL : type_together(m->buf, m->count, m->type, &bytes);
    *packed = at ? NULL : get_memory(bytes_of(m));
    if (!at && m->write)
        type_pack(m->buf, m->count, m->type, *packed);
    if (!at && m->write && m->f->external)
        type_reverse(m->type, *packed, bytes_of(m));
    return at ? at : *packed;
}

/* So many bytes have been read. */
static void data_come(const struct move *m, char *packed, size_t bytes)
{
    if (packed && m->f->external)
        type_reverse(m->type, packed, bytes);
    if (packed)
        type_unpack(packed, bytes, m->buf, m->count, m->type);
}

/* --- now --- */

static int fail_move(struct file *f, int call, bool write, int why)
{
    return fail_file(f, call, file_error(why), "%s cannot be %s", f->name, write ? "written" : "read");
}

static struct view_walk walk_of(const struct move *m)
{
    return view_walk(m->f, m->at * (MPI_Offset)size_of(m->f->etype), bytes_of(m));
}

static int move_pieces(const struct move *m, char *data, size_t *moved)
{
    struct view_walk w = walk_of(m);
    MPI_Offset at;
    size_t bytes;
    *moved = 0;
    while (view_next(&w, &at, &bytes)) {
        long some = nxm_move(&(struct nxm_move){m->call, m->f->fd, m->write, at, (long)bytes, data + *moved});
        if (some < 0)
            return fail_move(m->f, m->call, m->write, errno);
        *moved += (size_t)some;
        if ((size_t)some < bytes)
            break; /* the end of the file */
    }
    return MPI_SUCCESS;
}

static int move_now(const struct move *m, MPI_Status *status)
{
    char *packed, *data = data_of(m, &packed);
    size_t moved;
    if (m->f->atomic)
        server_lock(m->f, m->call);
    int code = move_pieces(m, data, &moved);
    if (m->f->atomic)
        server_unlock(m->f, m->call);
    if (!m->write && moved)
        data_come(m, packed, moved);
    free(packed);
    if (status)
        status_set(status, MPI_ANY_SOURCE, MPI_ANY_TAG, moved);
    return code;
}

/* --- later --- */

/* What the end of one under way needs. */
struct later {
    struct move move;
    long id;
};

static void end_later(struct request *r, bool waits)
{
    struct later *l = r->extra;
    const struct move *m = &l->move;
    long moved = nxm_moved(r->envelope.call, l->id, waits);
    if (moved == NXM_UNDER_WAY)
        return;
    r->status.MPI_ERROR = moved < 0 ? fail_move(m->f, r->envelope.call, m->write, errno) : MPI_SUCCESS;
    if (moved > 0 && !m->write)
        data_come(m, r->packed, (size_t)moved);
    status_set(&r->status, MPI_ANY_SOURCE, MPI_ANY_TAG, moved < 0 ? 0 : (size_t)moved);
    free(l);
    r->end = NULL;
}

/* Begins a movement of one piece. False: it has more pieces, or the node has no id left. */
static bool begin_one(const struct move *m, struct request *r)
{
    struct view_walk w = walk_of(m);
    MPI_Offset at;
    size_t bytes;
    if (m->f->atomic || !view_next(&w, &at, &bytes) || w.left)
        return false;
    char *packed, *data = data_of(m, &packed);
    long id = nxm_imove(&(struct nxm_move){m->call, m->f->fd, m->write, at, (long)bytes, data});
    if (id < 0)
        return free(packed), false;
    struct later *l = get_memory(sizeof *l);
    *l = (struct later){*m, id};
    r->packed = packed, r->extra = l, r->end = end_later;
    return true;
}

/* One that has several pieces is done when the call returns. */
static int move_later(const struct move *m, MPI_Request *request)
{
    struct request *r = request_new();
    r->what = MOVES, r->active = true;
    r->type = m->type;
    type_keep(m->type);
    status_empty(&r->status);
    if (!begin_one(m, r))
        r->status.MPI_ERROR = move_now(m, &r->status);
    *request = HANDLE(MPI_Request, r);
    return MPI_SUCCESS;
}

static int move(const struct move *m, MPI_Status *status, MPI_Request *request)
{
    return request ? move_later(m, request) : move_now(m, status);
}

/* --- where --- */

/* The file, and checks. places: the call names a place, or uses the rank's pointer. */
static int begin(struct move *m, MPI_File file, bool places)
{
    m->f = file_of(file);
    if (!m->f)
        return fail_no_file(m->call);
    int code = check(m);
    if (!code && places && m->f->amode & MPI_MODE_SEQUENTIAL)
        code = fail_file(m->f, m->call, MPI_ERR_UNSUPPORTED_OPERATION,
                         "the file is a sequential one: only the shared pointer leads to its bytes");
    return code;
}

static int at_place(struct move *m, MPI_File file, MPI_Offset place, MPI_Status *status, MPI_Request *request)
{
    int code = begin(m, file, true);
    if (code)
        return code;
    if (place < 0)
        return fail_file(m->f, m->call, MPI_ERR_ARG, "the place %ld is negative", (long)place);
    m->at = place;
    return move(m, status, request);
}

static MPI_Offset etypes(const struct file *f, size_t bytes)
{
    return bytes ? (MPI_Offset)(bytes / size_of(f->etype)) : 0;
}

/* A blocking read moves the pointer by what there was. */
static int at_pointer(struct move *m, MPI_File file, MPI_Status *status, MPI_Request *request)
{
    MPI_Status own;
    int code = begin(m, file, true);
    if (code)
        return code;
    m->at = m->f->pointer;
    status = status ? status : &own;
    code = move(m, status, request);
    m->f->pointer += etypes(m->f, request ? bytes_of(m) : status_bytes(status));
    return code;
}

static int at_shared(struct move *m, MPI_File file, MPI_Status *status, MPI_Request *request)
{
    int code = begin(m, file, false);
    if (code)
        return code;
    m->at = server_add(m->f, m->call, etypes(m->f, bytes_of(m)));
    return move(m, status, request);
}

/* Rank 0 takes the range of all; in it each has its own behind those of the ranks before. */
static int in_order(struct move *m, MPI_File file, MPI_Status *status, MPI_Request *request)
{
    int code = begin(m, file, false);
    if (!m->f)
        return code;
    const struct coll o = coll_of(m->f->comm, m->call);
    MPI_Offset own = code ? 0 : etypes(m->f, bytes_of(m)), all = 0, before = 0, first = 0;
    MPI_Offset *each = get_memory((size_t)o.size * sizeof *each);
    coll_allgather_bytes(&o, &own, sizeof own, each);
    for (int i = 0; i < o.size; i++) {
        before += i < o.rank ? each[i] : 0;
        all += each[i];
    }
    free(each);
    if (!o.rank)
        first = server_add(m->f, m->call, all);
    coll_bcast(&o, &first, 1, MPI_OFFSET, 0);
    m->at = first + before;
    return code ? code : move(m, status, request);
}

/* --- the calls --- */

#define BUF (void *)(uintptr_t)buf
#define MOVE(name, writes)                                                                                   \
    {                                                                                                        \
        .call = CALL_File_##name, .write = writes, .buf = BUF, .count = count, .type = type                  \
    }
#define AT_PLACE(name, writes, buffer)                                                                       \
    CALL(File_##name,                                                                                        \
         (MPI_File file, MPI_Offset place, buffer buf, int count, MPI_Datatype type, MPI_Status *status))    \
    {                                                                                                        \
        struct move m = MOVE(name, writes);                                                                  \
        return at_place(&m, file, place, status, NULL);                                                      \
    }                                                                                                        \
    CALL(File_i##name,                                                                                       \
         (MPI_File file, MPI_Offset place, buffer buf, int count, MPI_Datatype type, MPI_Request *request))  \
    {                                                                                                        \
        struct move m = MOVE(i##name, writes);                                                               \
        return at_place(&m, file, place, NULL, request);                                                     \
    }
#define AT_POINTER(name, writes, buffer, where)                                                              \
    CALL(File_##name, (MPI_File file, buffer buf, int count, MPI_Datatype type, MPI_Status *status))         \
    {                                                                                                        \
        struct move m = MOVE(name, writes);                                                                  \
        return where(&m, file, status, NULL);                                                                \
    }                                                                                                        \
    CALL(File_i##name, (MPI_File file, buffer buf, int count, MPI_Datatype type, MPI_Request *request))      \
    {                                                                                                        \
        struct move m = MOVE(i##name, writes);                                                               \
        return where(&m, file, NULL, request);                                                               \
    }
/* Of two calls the first does it, and keeps the status for the second. */
#define SECOND(name, buffer)                                                                                 \
    CALL(File_##name##_end, (MPI_File file, buffer buf, MPI_Status * status))                                \
    {                                                                                                        \
        const struct file *f = file_of(file);                                                                \
        (void)buf;                                                                                           \
        if (!f)                                                                                              \
            return fail_no_file(CALL_File_##name##_end);                                                     \
        if (status)                                                                                          \
            *status = f->split;                                                                              \
        return MPI_SUCCESS;                                                                                  \
    }
#define SPLIT_STATUS (file_of(file) ? &file_of(file)->split : NULL)
#define IN_TWO_CALLS(name, writes, buffer, where)                                                            \
    CALL(File_##name##_begin, (MPI_File file, buffer buf, int count, MPI_Datatype type))                     \
    {                                                                                                        \
        struct move m = MOVE(name##_begin, writes);                                                          \
        return where(&m, file, SPLIT_STATUS, NULL);                                                          \
    }                                                                                                        \
    SECOND(name, buffer)
#define AT_PLACE_IN_TWO_CALLS(name, writes, buffer)                                                          \
    CALL(File_##name##_begin, (MPI_File file, MPI_Offset place, buffer buf, int count, MPI_Datatype type))   \
    {                                                                                                        \
        struct move m = MOVE(name##_begin, writes);                                                          \
        return at_place(&m, file, place, SPLIT_STATUS, NULL);                                                \
    }                                                                                                        \
    SECOND(name, buffer)
#define CALLS(name, writes, buffer)                                                                          \
    AT_PLACE(name##_at, writes, buffer)                                                                      \
    AT_PLACE(name##_at_all, writes, buffer)                                                                  \
    AT_POINTER(name, writes, buffer, at_pointer)                                                             \
    AT_POINTER(name##_all, writes, buffer, at_pointer)                                                       \
    AT_POINTER(name##_shared, writes, buffer, at_shared)                                                     \
    CALL(File_##name##_ordered,                                                                              \
         (MPI_File file, buffer buf, int count, MPI_Datatype type, MPI_Status *status))                      \
    {                                                                                                        \
        struct move m = MOVE(name##_ordered, writes);                                                        \
        return in_order(&m, file, status, NULL);                                                             \
    }                                                                                                        \
    AT_PLACE_IN_TWO_CALLS(name##_at_all, writes, buffer)                                                     \
    IN_TWO_CALLS(name##_all, writes, buffer, at_pointer)                                                     \
    IN_TWO_CALLS(name##_ordered, writes, buffer, in_order)
CALLS(read, false, void *)
CALLS(write, true, const void *)
