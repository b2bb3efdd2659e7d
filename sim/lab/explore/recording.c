/* recording.c - see recording.h. */
#include "lab/explore/recording.h"
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

/* The words of a line of the file. */
struct item {
    char *word[12]; /* what stands before the first pair */
    int words;
    char *pairs; /* "key=value key=value ..." */
};

struct reader {
    struct recording *r;
    const char *path;
    int line;
    char **error;
};

static bool wrong(struct reader *in, const char *what)
{
    *in->error = xasprintf("%s:%d: %s", in->path, in->line, what);
    return false;
}

/* --- words ---------------------------------------------------------------------------------------------- */

static struct item split(char *line)
{
    struct item it = {0};
    char *rest = line;
    while (*(rest += strspn(rest, " \t\n"))) {
        size_t length = strcspn(rest, " \t\n");
        if (memchr(rest, '=', length) || it.words == 12)
            break;
        it.word[it.words++] = rest;
        rest += length;
        if (*rest)
            *rest++ = '\0';
    }
    it.pairs = rest;
    return it;
}

/* The value of a key; NULL: there is none. *length is its length. */
static const char *value_of(const struct item *it, const char *key, size_t *length)
{
    size_t size = strlen(key);
    for (const char *at = it->pairs; *at;) {
        at += strspn(at, " \t\n");
        size_t word = strcspn(at, " \t\n");
        if (word > size && at[size] == '=' && !memcmp(at, key, size)) {
            *length = word - size - 1;
            return at + size + 1;
        }
        at += word;
    }
    return NULL;
}

static char *text_of(const struct item *it, const char *key)
{
    size_t length;
    const char *value = value_of(it, key, &length);
    return value ? xstrndup(value, length) : NULL;
}

static int64_t number_of(const struct item *it, const char *key, int64_t otherwise)
{
    size_t length;
    const char *value = value_of(it, key, &length);
    return value ? strtoll(value, NULL, 10) : otherwise;
}

static vtime time_of(const struct item *it, const char *key)
{
    size_t length;
    const char *value = value_of(it, key, &length);
    return value ? strtoull(value, NULL, 10) : VT_NEVER;
}

static bool whole(const char *text, uint64_t *value)
{
    char *end;
    errno = 0;
    *value = strtoull(text, &end, 10);
    return *text >= '0' && *text <= '9' && !*end && !errno;
}

/* Reads the words from the `first` on: nodes where `what` has 'n', counts where it has 'c'. */
static bool numbers(struct reader *in, const struct item *it, const char *what, uint64_t value[])
{
    if (it->words < 1 + (int)strlen(what))
        return wrong(in, "too few words");
    for (int i = 0; what[i]; i++) {
        const char *word = it->word[i + 1];
        if (what[i] == 'n' && !strcmp(word, "host"))
            value[i] = in->r->nodes;
        else if (!whole(word, &value[i]) || (what[i] == 'n' && value[i] >= in->r->nodes))
            return wrong(in, "not a node or a count from 0 up");
    }
    return true;
}

/* --- items ---------------------------------------------------------------------------------------------- */

static void add_message(struct recording *r, const struct item *it, const uint64_t v[3], bool taken)
{
    r->messages = xgrown(r->messages, r->message_count, sizeof *r->messages);
    r->messages[r->message_count++] = (struct rec_message){.from = (uint32_t)v[1],
                                                           .to = (uint32_t)v[0],
                                                           .number = v[2],
                                                           .index = (uint64_t)number_of(it, "i", -1),
                                                           .type = number_of(it, "type", 0),
                                                           .sent = time_of(it, "sent"),
                                                           .came = time_of(it, "came"),
                                                           .bytes = number_of(it, "bytes", 0),
                                                           .taken = taken ? 0 : REC_NONE,
                                                           .line = text_of(it, "from")};
}

static bool take_match(struct reader *in, const struct item *it)
{
    struct recording *r = in->r;
    uint64_t v[4];
    if (!numbers(in, it, "ncnc", v))
        return false;
    add_message(r, it, (uint64_t[]){v[0], v[2], v[3]}, true);
    r->receives = xgrown(r->receives, r->receive_count, sizeof *r->receives);
    r->receives[r->receive_count++] = (struct rec_receive){.node = (uint32_t)v[0],
                                                           .number = v[1],
                                                           .from = (uint32_t)v[2],
                                                           .from_number = v[3],
                                                           .typesel = number_of(it, "typesel", -1),
                                                           .selected = number_of(it, "sel", REC_ANY),
                                                           .posted = time_of(it, "posted"),
                                                           .at = time_of(it, "at"),
                                                           .call = text_of(it, "call"),
                                                           .line = text_of(it, "line")};
    return true;
}

static bool take_left(struct reader *in, const struct item *it)
{
    uint64_t v[3];
    if (!numbers(in, it, "nnc", v))
        return false;
    add_message(in->r, it, v, false);
    return true;
}

static bool take_handler(struct reader *in, const struct item *it)
{
    struct recording *r = in->r;
    uint64_t v[3];
    if (!numbers(in, it, "ncc", v))
        return false;
    r->handlers = xgrown(r->handlers, r->handler_count, sizeof *r->handlers);
    r->handlers[r->handler_count++] = (struct rec_handler){.node = (uint32_t)v[0],
                                                           .number = v[1],
                                                           .calls = v[2],
                                                           .receive = number_of(it, "match", REC_NONE),
                                                           .due = time_of(it, "due"),
                                                           .at = time_of(it, "at"),
                                                           .line = text_of(it, "line")};
    return true;
}

static bool take_delay(struct reader *in, const struct item *it, enum delay_kind kind)
{
    uint64_t v[3];
    bool indexed = delay_kind_is_indexed(kind);
    if (!numbers(in, it, indexed ? "ncc" : "nc", v))
        return false;
    struct delay d = {kind, (uint32_t)v[0], indexed ? v[1] : 0, (int64_t)(indexed ? v[2] : v[1])};
    if (d.value) /* recordings tell of all messages */
        delays_append(&in->r->delays, d);
    return true;
}

static bool take_nodes(struct reader *in, const struct item *it)
{
    uint64_t n;
    if (it->words < 2 || !whole(it->word[1], &n) || n > UINT32_MAX - 1)
        return wrong(in, "nodes: a number of nodes is missing");
    in->r->nodes = (uint32_t)n;
    return true;
}

/* Items that this reader does not know are for others. */
static bool take(struct reader *in, const struct item *it)
{
    const char *name = it->word[0];
    for (enum delay_kind kind = 0; kind < DELAY_KINDS; kind++)
        if (!strcmp(name, delay_kind_name(kind)))
            return take_delay(in, it, kind);
    return !strcmp(name, "match")     ? take_match(in, it)
           : !strcmp(name, "left")    ? take_left(in, it)
           : !strcmp(name, "handler") ? take_handler(in, it)
           : !strcmp(name, "nodes")   ? take_nodes(in, it)
                                      : true;
}

static bool read_lines(struct reader *in, FILE *f)
{
    char *line = NULL;
    size_t room = 0;
    bool good = true;
    while (good && getline(&line, &room, f) >= 0) {
        in->line++;
        line[strcspn(line, "#")] = '\0';
        struct item it = split(line);
        if (in->line == 1 && (it.words < 2 || strcmp(it.word[0], "touchstone-schedule")))
            good = wrong(in, "this is no schedule: it does not begin with touchstone-schedule");
        else if (it.words)
            good = take(in, &it);
    }
    free(line);
    if (good && !in->line)
        good = wrong(in, "the file is empty");
    return good;
}

/* --- tables --------------------------------------------------------------------------------------------- */

#define ORDER(a, b) ((a) < (b) ? -1 : (a) > (b))

static int by_sender(const void *a, const void *b)
{
    const struct rec_message *x = a, *y = b;
    return x->from != y->from ? ORDER(x->from, y->from)
           : x->to != y->to   ? ORDER(x->to, y->to)
                              : ORDER(x->number, y->number);
}

static int by_receiver(const void *a, const void *b)
{
    const struct rec_receive *x = a, *y = b;
    return x->node != y->node ? ORDER(x->node, y->node) : ORDER(x->number, y->number);
}

static int by_node(const void *a, const void *b)
{
    const struct rec_handler *x = a, *y = b;
    return x->node != y->node ? ORDER(x->node, y->node) : ORDER(x->number, y->number);
}

static void sort(void *table, size_t count, size_t size, int (*compare)(const void *, const void *))
{
    if (count)
        qsort(table, count, size, compare);
}

/* The message that `from` sent to `to` as its number-th; NULL: there is none. */
static const struct rec_message *message(const struct recording *r, uint32_t from, uint32_t to,
                                         uint64_t number)
{
    struct rec_message key = {.from = from, .to = to, .number = number};
    return r->message_count ? bsearch(&key, r->messages, r->message_count, sizeof key, by_sender) : NULL;
}

static void connect(struct recording *r)
{
    sort(r->messages, r->message_count, sizeof *r->messages, by_sender);
    sort(r->receives, r->receive_count, sizeof *r->receives, by_receiver);
    sort(r->handlers, r->handler_count, sizeof *r->handlers, by_node);
    for (size_t i = 0; i < r->receive_count; i++) {
        struct rec_receive *v = &r->receives[i];
        const struct rec_message *m = message(r, v->from, v->node, v->from_number);
        v->message = m - r->messages;
        r->messages[v->message].taken = (int64_t)i;
    }
}

const struct rec_receive *recording_receive(const struct recording *r, uint32_t node, uint64_t number)
{
    struct rec_receive key = {.node = node, .number = number};
    return r->receive_count ? bsearch(&key, r->receives, r->receive_count, sizeof key, by_receiver) : NULL;
}

const struct rec_handler *recording_handler(const struct recording *r, uint32_t node, uint64_t number)
{
    struct rec_handler key = {.node = node, .number = number};
    return r->handler_count ? bsearch(&key, r->handlers, r->handler_count, sizeof key, by_node) : NULL;
}

struct recording *recording_read(FILE *f, const char *path, char **error)
{
    struct recording *r = xcalloc(1, sizeof *r);
    struct reader in = {.r = r, .path = path, .error = error};
    if (!read_lines(&in, f)) {
        recording_free(r);
        return NULL;
    }
    connect(r);
    return r;
}

struct recording *recording_load(const char *path, char **error)
{
    FILE *f = fopen(path, "re");
    if (!f) {
        *error = xasprintf("%s cannot be read: %m", path);
        return NULL;
    }
    struct recording *r = recording_read(f, path, error);
    fclose(f);
    return r;
}

void recording_free(struct recording *r)
{
    if (!r)
        return;
    for (size_t i = 0; i < r->message_count; i++)
        free(r->messages[i].line);
    for (size_t i = 0; i < r->receive_count; i++)
        free(r->receives[i].call), free(r->receives[i].line);
    for (size_t i = 0; i < r->handler_count; i++)
        free(r->handlers[i].line);
    delays_free(&r->delays);
    free(r->messages);
    free(r->receives);
    free(r->handlers);
    free(r);
}

uint32_t recording_programs(const struct recording *r)
{
    bool *seen = xcalloc(r->nodes + 1, sizeof *seen);
    uint32_t count = 0;
    for (size_t i = 0; i < r->message_count; i++)
        seen[r->messages[i].from] = seen[r->messages[i].to] = true;
    for (uint32_t node = 0; node <= r->nodes; node++)
        count += seen[node];
    count = seen[r->nodes] ? count : r->nodes;
    free(seen);
    return count;
}
