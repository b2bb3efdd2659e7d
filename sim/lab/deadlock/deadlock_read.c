/* deadlock_read.c - see deadlock_read.h. nx_api/waitfor/waitfor_write_json.c has the form. */
#include "lab/deadlock/deadlock_read.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

/* --- values; what is not there is 0, NULL or never --- */

static long number(const json_t *j, const char *key)
{
    return (long)json_integer_value(json_object_get(j, key));
}

static bool truth(const json_t *j, const char *key)
{
    return json_is_true(json_object_get(j, key));
}

static uint64_t time_ps(const json_t *j, const char *key)
{
    const json_t *t = json_object_get(j, key);
    return json_is_integer(t) ? (uint64_t)json_integer_value(t) : WAITFOR_NEVER;
}

static const char *text(struct waitfor *w, const json_t *j, const char *key)
{
    return waitfor_text(w, json_string_value(json_object_get(j, key)));
}

/* The index of a member's text in a list of `count` words; 0 if it is none of them. */
static int word(const json_t *j, const char *key, const char *const *words, int count)
{
    const char *value = json_string_value(json_object_get(j, key));
    for (int i = 0; value && i < count; i++)
        if (!strcmp(value, words[i]))
            return i;
    return 0;
}
#define WORD(j, key, ...)                                                                                    \
    word(j, key, (const char *const[]){__VA_ARGS__}, sizeof(const char *[]){__VA_ARGS__} / sizeof(char *))

static struct waitfor_select selector(const json_t *j, const char *key)
{
    const json_t *s = json_object_get(j, key);
    return (struct waitfor_select){number(s, "typesel"), number(s, "node"), number(s, "pid")};
}

/* --- a node --- */

static void read_mailbox(struct waitfor *w, struct waitfor_node *n, const json_t *j)
{
    size_t i;
    const json_t *m;
    json_array_foreach(json_object_get(j, "messages"), i, m)
        waitfor_add_message(n, &(struct waitfor_message){.type = number(m, "type"),
                                                         .from = number(m, "from"),
                                                         .pid = number(m, "pid"),
                                                         .bytes = (size_t)number(m, "bytes"),
                                                         .sent_ps = time_ps(m, "sent_ps"),
                                                         .came_ps = time_ps(m, "came_ps"),
                                                         .held_back = truth(m, "held_back")});
    n->more_messages = (uint64_t)number(j, "more_messages");
    json_array_foreach(json_object_get(j, "receives"), i, m)
        waitfor_add_receive(n, &(struct waitfor_receive){.select = selector(m, "select"),
                                                         .has_handler = truth(m, "has_handler"),
                                                         .filled = truth(m, "filled"),
                                                         .type = number(m, "type"),
                                                         .from = number(m, "from"),
                                                         .line = text(w, m, "line")});
    json_array_foreach(json_object_get(j, "taken"), i, m) waitfor_add_taken(
        n, &(struct waitfor_taken){
               .fate = (enum waitfor_fate)WORD(m, "fate", "received", "handled", "flushed", "discarded"),
               .type = number(m, "type"),
               .from = number(m, "from"),
               .pid = number(m, "pid"),
               .bytes = (size_t)number(m, "bytes"),
               .by = selector(m, "by"),
               .call = text(w, m, "call"),
               .line = text(w, m, "line"),
               .came_ps = time_ps(m, "came_ps")});
}

static void read_wait(struct waitfor_node *n, const json_t *j)
{
    const json_t *wait = json_object_get(j, "waits_for");
    n->what = (enum waitfor_what)WORD(wait, "what", "message", "buffer", "end", "handler", "other");
    n->select = selector(wait, "select");
    n->to = number(wait, "to");
    n->of_all = truth(wait, "of_all");
    n->to_bytes = (size_t)number(wait, "bytes");
}

static void read_node(struct waitfor *w, struct waitfor_node *n, const json_t *j)
{
    size_t i;
    const json_t *frame;
    n->name = text(w, j, "name");
    n->number = number(j, "number");
    n->is_host = n->name && !strcmp(n->name, "host");
    n->state = (enum waitfor_state)WORD(j, "state", "no program", "waits", "computes", "ended");
    n->call = text(w, j, "call");
    n->has_type = json_object_get(j, "type") != NULL;
    n->type = number(j, "type");
    n->since_ps = time_ps(j, "since_ps");
    n->exit_status = (int)number(j, "exit_status");
    n->line = text(w, j, "line");
    json_array_foreach(json_object_get(j, "stack"), i, frame)
        waitfor_add_frame(w, n, json_string_value(frame));
    read_wait(n, j);
    n->masked = truth(j, "masked");
    n->in_handler = truth(j, "in_handler");
    n->due = (uint32_t)number(j, "due");
    n->buffered_bytes = (size_t)number(j, "buffered_bytes");
    n->buffer_bytes = (size_t)number(j, "buffer_bytes");
    read_mailbox(w, n, j);
}

/* --- all --- */

struct waitfor *deadlock_of_json(const json_t *j)
{
    const json_t *inner = json_object_get(j, "deadlock"), *n;
    size_t i;
    j = json_is_object(inner) ? inner : j;
    const json_t *nodes = json_object_get(j, "nodes");
    if (!json_is_array(nodes) || !json_object_get(j, "cycle") || !json_object_get(j, "now_ps"))
        return NULL;
    struct waitfor *w = waitfor_new((uint32_t)json_array_size(nodes));
    w->program = text(w, j, "program");
    w->clock = text(w, j, "clock");
    w->now_ps = time_ps(j, "now_ps");
    json_array_foreach(nodes, i, n) read_node(w, &w->nodes[i], n);
    waitfor_analyse(w);
    return w;
}

#define NO_REPORT "no report of a deadlock (touchstone run --deadlock FILE, or --json FILE)"

struct waitfor *deadlock_read(const char *path, char **error)
{
    json_error_t why;
    json_t *j = json_load_file(path, JSON_DECODE_ANY, &why);
    if (!j && why.line < 0) {
        *error = xasprintf("%s cannot be read: %s", path, strerror(errno));
        return NULL;
    }
    if (!j) {
        *error = xasprintf("%s:%d: " NO_REPORT ": %s", path, why.line, why.text);
        return NULL;
    }
    struct waitfor *w = deadlock_of_json(j);
    if (!w && (json_is_null(j) || json_object_get(j, "outcome")))
        *error = xasprintf("%s: that run did not end in a deadlock", path);
    else if (!w)
        *error = xasprintf("%s: " NO_REPORT, path);
    json_decref(j);
    return w;
}
