/* run_verdict.c - see run_verdict.h. */
#include "lab/explore/run_verdict.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include "files/json_set.h"
#include "files/text_file.h"
#include "kernel/xalloc.h"
#include "lab/jobs/digest.h"
#include "files/words.h"

enum { MOST_SHOWN = 4096 };
static const char NO_FILE[] = "digest of the file: there is none\n";

/* --- lines ---------------------------------------------------------------------------------------------- */

struct lines {
    char **list;
    size_t count;
};

static void add_line(struct lines *l, char *line)
{
    l->list = xgrown(l->list, l->count, sizeof *l->list);
    l->list[l->count++] = line;
}

static void free_lines(struct lines *l)
{
    for (size_t i = 0; i < l->count; i++)
        free(l->list[i]);
    free(l->list);
}

static int by_text(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static void sort_lines(struct lines *l)
{
    if (l->count)
        qsort(l->list, l->count, sizeof *l->list, by_text);
}

static char *joined(const struct lines *l)
{
    size_t size = 1;
    for (size_t i = 0; i < l->count; i++)
        size += strlen(l->list[i]) + 1;
    char *text = xmalloc(size), *end = text;
    for (size_t i = 0; i < l->count; i++) {
        end = stpcpy(end, l->list[i]);
        *end++ = '\n';
    }
    *end = '\0';
    return text;
}

/* The output's lines that count, as printed or sorted. */
static char *compared(const struct verdict_rules *rules, const char *out, bool as_printed)
{
    struct lines l = {0};
    for (const char *at = out; *at; at += *at == '\n') {
        size_t length = strcspn(at, "\n");
        char *line = xstrndup(at, length);
        at += length;
        if (rules->same && regexec(rules->same, line, 0, NULL, 0))
            free(line);
        else
            add_line(&l, line);
    }
    if (!as_printed)
        sort_lines(&l);
    char *text = joined(&l);
    free_lines(&l);
    return text;
}

/* --- messages ------------------------------------------------------------------------------------------- */

static bool is_of_name(char c)
{
    return isalnum((unsigned char)c) || strchr("._-/+", c);
}

/* The places "file.c:42" in a message, each once, sorted: they are the same whatever the times and nodes. */
static char *places_in(const char *message)
{
    struct lines l = {0};
    for (const char *colon = message; (colon = strchr(colon, ':')); colon++) {
        const char *begin = colon, *end = colon + 1;
        while (begin > message && is_of_name(begin[-1]) && begin[-1])
            begin--;
        while (isdigit((unsigned char)*end))
            end++;
        if (end > colon + 1 && memchr(begin, '.', (size_t)(colon - begin)))
            add_line(&l, xstrndup(begin, (size_t)(end - begin)));
    }
    sort_lines(&l);
    size_t kept = 0;
    for (size_t i = 0; i < l.count; i++)
        if (kept && !strcmp(l.list[kept - 1], l.list[i]))
            free(l.list[i]);
        else
            l.list[kept++] = l.list[i];
    l.count = kept;
    char *text = joined(&l);
    free_lines(&l);
    return text;
}

/* The lines of a report that say where a node waits; all of it if there are none. */
static char *waits_in(const char *message)
{
    char *waits = xstrdup("");
    for (const char *at = message; *at; at += *at == '\n') {
        size_t length = strcspn(at, "\n");
        if (memmem(at, length, " since ", 7))
            words_append(&waits, "%.*s\n", (int)length, at);
        at += length;
    }
    if (!*waits)
        words_append(&waits, "%s", message);
    return waits;
}

/* Is the word a unit of time, with a comma or colon behind it or not? */
static bool is_unit(const char *word, size_t length)
{
    static const char *const UNITS[] = {"s", "ms", "us", "ns"};
    length -= length > 1 && strchr(",:;", word[length - 1]);
    for (size_t i = 0; i < sizeof UNITS / sizeof *UNITS; i++)
        if (strlen(UNITS[i]) == length && !strncmp(word, UNITS[i], length))
            return true;
    return false;
}

/* The words of the first line, but for those with digits, nodes, times, addresses, and the units of times. */
static char *first_line(const char *message)
{
    char *text = xstrdup("");
    for (const char *at = message; *at && *at != '\n';) {
        size_t length = strcspn(at, " \n");
        if (length && strcspn(at, "0123456789") >= length && !is_unit(at, length))
            words_append(&text, "%.*s ", (int)length, at);
        at += length + (at[length] == ' ');
    }
    return text;
}

/* Of a run that did not end: the same for all nodes and times. */
static char *of_unended(const char *end, const char *message)
{
    bool deadlock = !strcmp(end, "deadlock");
    char *waits = waits_in(message), *places = places_in(waits), *line = first_line(message);
    char *text = xasprintf("%s%s%s", deadlock ? "" : line, deadlock ? "" : "\n", places);
    free(waits);
    free(places);
    free(line);
    return text;
}

/* --- the record ----------------------------------------------------------------------------------------- */

static void set_digest(json_t *record, const char *key, const char *text)
{
    json_set(record, key, digest_json(digest_of(text, strlen(text))));
}

/* The text's first lines. */
static json_t *shown(const char *text)
{
    char *first = xstrndup(text, text_cut(text, MOST_SHOWN));
    json_t *string = json_text(first);
    free(first);
    return string;
}

static char *file_text(const char *path)
{
    struct digest d;
    return digest_file(path, &d) ? xasprintf("digest of the file: %s\n", digest_text(d).text)
                                 : xstrdup(NO_FILE);
}

static char *of_ended(const struct verdict_rules *rules, const char *out, const char *file)
{
    char *text = rules->file_only && file ? xstrdup("") : compared(rules, out, rules->ordered);
    char *of_file = file ? file_text(file) : xstrdup("");
    words_append(&text, "%s", of_file);
    free(of_file);
    return text;
}

static void set_lines(json_t *record, const struct verdict_rules *rules, const char *out)
{
    char *text = compared(rules, out, true);
    set_digest(record, "lines", text);
    free(text);
}

json_t *verdict_of(const struct verdict_rules *rules, const char *out, const char *json, const char *file)
{
    json_t *run = json_load_file(json, 0, NULL), *record = json_object();
    const char *end = json_string_value(json_object_get(run, "outcome"));
    const char *message = json_string_value(json_object_get(run, "message"));
    if (!end) {
        json_decref(run);
        json_decref(record);
        return NULL;
    }
    bool ended = !strcmp(end, "ended");
    char *text = ended ? of_ended(rules, out, file) : of_unended(end, message ? message : "");
    char *whole = xasprintf("%s\n%s", end, text);
    json_set(record, "end", json_string(end));
    set_digest(record, "group", whole);
    json_set(record, "shown", shown(text));
    if (ended)
        set_lines(record, rules, out);
    else
        json_set(record, "message", json_string(message ? message : ""));
    json_set(record, "virtual_time_s", json_incref(json_object_get(run, "virtual_time_s")));
    if (json_object_get(run, "races"))
        json_set(record, "races", json_incref(json_object_get(run, "races")));
    json_set(record, "host_files", json_incref(json_object_get(run, "host_files")));
    free(whole);
    free(text);
    json_decref(run);
    return record;
}

bool verdict_lacks_file(const json_t *record)
{
    const char *shown = json_string_value(json_object_get(record, "shown"));
    return shown && strstr(shown, NO_FILE);
}
