/* journal.c - see journal.h. The table of points is a hash table with open addressing, at most half full. */
#include "lab/jobs/journal.h"
#include "kernel/xalloc.h"
#include "lab/jobs/scratch_memory.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

struct slot {
    struct digest key;
    uint64_t offset; /* of the point's last line, plus 1; 0: this slot is free */
    uint32_t size;   /* of the line without its newline */
    uint32_t state;
};

struct journal {
    int fd;
    char *path;
    FILE *notes;
    uint64_t read_to; /* complete lines end here */
    size_t line;      /* number of lines read */
    struct slot *slots;
    size_t capacity, count;
    char *buffer; /* for reading; grows until a line fits */
    size_t buffer_size;
};

enum { FIRST_CAPACITY = 1 << 10, FIRST_BUFFER = 1 << 16, FORGOTTEN = 0 /* as a state */ };

/* --- the table ------------------------------------------------------------------------------------------ */

static struct slot *slot_of(struct slot *slots, size_t capacity, struct digest key)
{
    size_t i = key.low & (capacity - 1);
    while (slots[i].offset && !digest_equal(slots[i].key, key))
        i = (i + 1) & (capacity - 1);
    return &slots[i];
}

static void grow(struct journal *j)
{
    size_t capacity = j->capacity ? 2 * j->capacity : FIRST_CAPACITY;
    struct slot *slots = scratch_memory_new(capacity * sizeof *slots);
    for (size_t i = 0; i < j->capacity; i++)
        if (j->slots[i].offset)
            *slot_of(slots, capacity, j->slots[i].key) = j->slots[i];
    scratch_memory_free(j->slots, j->capacity * sizeof *slots);
    j->slots = slots;
    j->capacity = capacity;
}

static void note(struct journal *j, struct digest key, enum journal_line_state state, uint64_t offset,
                 size_t size)
{
    if (2 * (j->count + 1) > j->capacity)
        grow(j);
    struct slot *p = slot_of(j->slots, j->capacity, key);
    j->count += !p->offset;
    *p = (struct slot){key, offset + 1, (uint32_t)size, state};
}

/* --- reading -------------------------------------------------------------------------------------------- */

static void take_line(struct journal *j, const char *line, size_t size)
{
    struct digest key;
    enum journal_line_state state;
    j->line++;
    if (!journal_line_check(line, size, &key, &state))
        fprintf(j->notes, "%s:%zu: this line is damaged: its point counts as not run\n", j->path, j->line);
    else if (state != LINE_HEAD)
        note(j, key, state, j->read_to, size);
    j->read_to += size + 1;
}

void journal_refresh(struct journal *j)
{
    for (;;) {
        ssize_t got = pread(j->fd, j->buffer, j->buffer_size, (off_t)j->read_to);
        size_t begin = 0, all = got > 0 ? (size_t)got : 0;
        for (char *end; (end = memchr(j->buffer + begin, '\n', all - begin));
             begin = (size_t)(end - j->buffer) + 1)
            take_line(j, j->buffer + begin, (size_t)(end - j->buffer) - begin);
        if (begin == 0 && all == j->buffer_size) {
            j->buffer = xrealloc(j->buffer, j->buffer_size *= 2);
            continue;
        }
        if (begin == 0)
            return; /* nothing more, or a line that is not complete */
    }
}

void journal_forget_failed(struct journal *j)
{
    for (size_t i = 0; i < j->capacity; i++)
        if (j->slots[i].state == LINE_FAILED)
            j->slots[i].state = FORGOTTEN;
}

/* NULL if the point has no line, or its failure was forgotten. */
static const struct slot *find(const struct journal *j, struct digest key)
{
    const struct slot *p = slot_of(j->slots, j->capacity, key);
    return p->offset && p->state != FORGOTTEN ? p : NULL;
}

bool journal_find(const struct journal *j, struct digest key, enum journal_line_state *state)
{
    const struct slot *p = find(j, key);
    if (p && state)
        *state = (enum journal_line_state)p->state;
    return p;
}

json_t *journal_record(const struct journal *j, struct digest key)
{
    const struct slot *p = find(j, key);
    char *line = p ? xmalloc(p->size) : NULL;
    json_t *record = NULL;
    if (line && pread(j->fd, line, p->size, (off_t)p->offset - 1) == (ssize_t)p->size)
        record = journal_line_record(line, p->size);
    free(line);
    return record;
}

void journal_each(const struct journal *j, void (*visit)(void *arg, struct digest key, const json_t *record),
                  void *arg)
{
    for (size_t i = 0; i < j->capacity; i++) {
        json_t *record = j->slots[i].offset ? journal_record(j, j->slots[i].key) : NULL;
        if (record)
            visit(arg, j->slots[i].key, record);
        json_decref(record);
    }
}

size_t journal_count(const struct journal *j)
{
    return j->count;
}

uint64_t journal_size(const struct journal *j)
{
    return j->read_to;
}

/* --- adding --------------------------------------------------------------------------------------------- */

static bool lock(struct journal *j, short type)
{
    struct flock all = {.l_type = type, .l_whence = SEEK_SET};
    int done;
    while ((done = fcntl(j->fd, F_OFD_SETLKW, &all)) != 0 && errno == EINTR)
        ;
    return done == 0;
}

/* Reads on to the end of the last complete line and cuts off what follows: a dead writer's part of a line.
 * Call with the file locked. */
static bool find_end(struct journal *j)
{
    struct stat st;
    journal_refresh(j);
    return fstat(j->fd, &st) == 0 &&
           ((uint64_t)st.st_size == j->read_to || ftruncate(j->fd, (off_t)j->read_to) == 0);
}

static bool put(struct journal *j, const char *line, size_t size)
{
    for (size_t done = 0; done < size;) {
        ssize_t n = pwrite(j->fd, line + done, size - done, (off_t)(j->read_to + done));
        if (n < 0 && errno != EINTR)
            return false;
        done += n > 0 ? (size_t)n : 0;
    }
    return true;
}

/* Adds a line. Call with the file locked. */
static bool append(struct journal *j, struct digest key, enum journal_line_state state, const json_t *record,
                   bool safe, char **error)
{
    size_t size;
    char *line = journal_line_write(key, state, record, &size);
    bool ok = find_end(j) && put(j, line, size) && (!safe || fdatasync(j->fd) == 0);
    if (ok) {
        take_line(j, line, size - 1);
    } else {
        *error = xasprintf("%s cannot be written: %m", j->path);
        if (ftruncate(j->fd, (off_t)j->read_to) != 0) /* leave no partial line */
            fprintf(j->notes, "%s ends with a part of a line\n", j->path);
    }
    free(line);
    return ok;
}

static bool lock_to_write(struct journal *j, char **error)
{
    bool ok = lock(j, F_WRLCK);
    if (!ok)
        *error = xasprintf("%s cannot be locked: %m", j->path);
    return ok;
}

bool journal_add(struct journal *j, struct digest key, enum journal_line_state state, const json_t *record,
                 bool safe, char **error)
{
    bool ok = lock_to_write(j, error);
    if (ok) {
        ok = append(j, key, state, record, safe, error);
        lock(j, F_UNLCK);
    }
    return ok;
}

/* --- opening -------------------------------------------------------------------------------------------- */

/* The first line says what the file is. */
static bool check_head(struct journal *j, char **error)
{
    char line[256];
    struct digest key;
    enum journal_line_state state = 0;
    ssize_t got = pread(j->fd, line, sizeof line, 0);
    char *end = got > 0 ? memchr(line, '\n', (size_t)got) : NULL;
    if (end && journal_line_check(line, (size_t)(end - line), &key, &state) && state == LINE_HEAD)
        return true;
    *error = xasprintf("%s:1: this is no journal of a study; remove it, or give another folder", j->path);
    return false;
}

static json_t *head_record(void)
{
    return json_pack("{s:i}", "journal of a touchstone study", 1);
}

/* Writes the first line. Call with the file locked. */
static bool begin(struct journal *j, const char *dir, char **error)
{
    json_t *head = head_record();
    bool ok = append(j, (struct digest){0}, LINE_HEAD, head, true, error);
    int folder = open(dir, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder >= 0) {
        fsync(folder); /* makes the file's name durable */
        close(folder);
    }
    json_decref(head);
    return ok;
}

/* Has the file nothing, or, of a dead writer, a part of the first line? */
static bool is_empty(const struct journal *j)
{
    char text[256];
    size_t size;
    ssize_t got = pread(j->fd, text, sizeof text, 0);
    json_t *head = head_record();
    char *line = journal_line_write((struct digest){0}, LINE_HEAD, head, &size);
    bool part = got <= 0 || ((size_t)got < size && !memcmp(text, line, (size_t)got));
    json_decref(head);
    free(line);
    return part;
}

/* Of processes that make the journal together, the first writes the head. */
static bool read_or_begin(struct journal *j, const char *dir, char **error)
{
    if (!lock_to_write(j, error))
        return false;
    bool ok = is_empty(j) ? begin(j, dir, error) : check_head(j, error);
    lock(j, F_UNLCK);
    return ok;
}

struct journal *journal_open(const char *dir, FILE *notes, char **error)
{
    struct journal *j = xcalloc(1, sizeof *j);
    j->buffer = xmalloc(FIRST_BUFFER);
    j->buffer_size = FIRST_BUFFER;
    j->notes = notes;
    j->path = xasprintf("%s/journal", dir);
    j->fd = open(j->path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    grow(j);
    bool ok = j->fd >= 0;
    if (!ok)
        *error = xasprintf("%s cannot be opened: %m", j->path);
    else if ((ok = read_or_begin(j, dir, error)))
        journal_refresh(j);
    if (ok)
        return j;
    journal_close(j);
    return NULL;
}

void journal_close(struct journal *j)
{
    if (!j)
        return;
    if (j->fd >= 0) {
        fdatasync(j->fd);
        close(j->fd);
    }
    scratch_memory_free(j->slots, j->capacity * sizeof *j->slots);
    free(j->buffer);
    free(j->path);
    free(j);
}
