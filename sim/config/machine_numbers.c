/* machine_numbers.c - see machine_numbers.h. */
#include "config/machine_numbers.h"
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "config/reader.h"
#include "config/setting.h"
#include "files/text_file.h"
#include "kernel/xalloc.h"

/* --- comments ------------------------------------------------------------------------------------------- */

/* The next line; NULL: there is none. */
static const char *next_line(const char *line)
{
    line += strcspn(line, "\n");
    return *line ? line + 1 : NULL;
}

/* The line's comment, behind the '#'; NULL: there is none. */
static const char *comment_in(const char *line)
{
    bool quoted = false;
    for (; *line && *line != '\n'; line++) {
        quoted ^= *line == '"';
        if (*line == '#' && !quoted)
            return line + 1;
    }
    return NULL;
}

static size_t indent(const char *line)
{
    return strspn(line, " \t");
}

static void add_words(FILE *to, const char *text)
{
    int length = (int)strcspn(text, "\n"), blanks = (int)indent(text);
    fprintf(to, "%s%.*s", ftell(to) ? " " : "", length - blanks, text + blanks);
}

/* The comment behind the setting of a line, with the lines below that have nothing else, and stand further to
 * the right than the setting. Malloc'd. */
static char *comment_of(const char *line)
{
    char *text = NULL;
    size_t size, left = indent(line);
    FILE *to = xchecked(open_memstream(&text, &size));
    const char *comment = comment_in(line);
    while (comment) {
        add_words(to, comment);
        line = next_line(line);
        comment = line && indent(line) > left && line[indent(line)] == '#' ? comment_in(line) : NULL;
    }
    fclose(to);
    return text;
}

/* Divides a comment, "known: 8 MB/s (Dunigan)". "the same" has the standing of the number before. */
static void divide(struct cfg_number *n, const char *comment, const struct cfg_number *before)
{
    static const char *const WORDS[] = {"read", "known", "derived", "fitted", "open"};
    size_t length = strcspn(comment, " ,.:;");
    const char *standing = before && !strncmp(comment, "the same", 8) ? before->standing : "";
    for (size_t i = 0; i < sizeof WORDS / sizeof *WORDS; i++)
        if (length == strlen(WORDS[i]) && !strncmp(comment, WORDS[i], length)) {
            standing = WORDS[i];
            comment += length + strspn(comment + length, " ,.:;");
            break;
        }
    n->standing = xstrdup(standing);
    n->source = xstrdup(comment);
}

/* --- settings ------------------------------------------------------------------------------------------- */

static char *value_of(const config_setting_t *s)
{
    switch (config_setting_type(s)) {
    case CONFIG_TYPE_FLOAT:
        return xasprintf("%.15g", config_setting_get_float(s));
    case CONFIG_TYPE_STRING:
        return xstrdup(config_setting_get_string(s));
    case CONFIG_TYPE_BOOL:
        return xstrdup(config_setting_get_bool(s) ? "true" : "false");
    default:
        return xasprintf("%lld", config_setting_get_int64(s));
    }
}

/* A file as it is walked. */
struct walk {
    struct cfg_reader *r;
    struct cfg_numbers *to;
};

/* The comment of a setting, malloc'd; NULL with the reader's error. */
static char *comment_at(struct walk *w, config_setting_t *s)
{
    char *path = cfg_path_at(w->r, s), *comment = NULL;
    const char *why = NULL;
    int at = 0;
    char *text = text_file_read(path, SIZE_MAX, &why, &at);
    const char *line = text;
    for (unsigned i = 1; line && i < config_setting_source_line(s); i++)
        line = next_line(line);
    if (text)
        comment = comment_of(line ? line : "");
    else
        cfg_fail(w->r, s, NULL, "cannot be read: %s", why);
    free(text);
    free(path);
    return comment;
}

static bool add(struct walk *w, config_setting_t *s, const char *key)
{
    struct cfg_numbers *n = w->to;
    char *comment = config_setting_get_hook(s) ? xstrdup("") : comment_at(w, s);
    if (!comment)
        return false;
    n->list = xreallocarray(n->list, n->count + 1, sizeof *n->list);
    struct cfg_number *number = &n->list[n->count++];
    *number = (struct cfg_number){.key = xstrdup(key), .value = value_of(s)};
    divide(number, comment, n->count > 1 ? number - 1 : NULL);
    number->is_number = config_setting_is_number(s);
    if (config_setting_get_hook(s)) {
        free(number->standing);
        number->standing = xstrdup("set");
    }
    free(comment);
    return true;
}

static bool walk_group(struct walk *w, const config_setting_t *group, const char *prefix)
{
    bool good = true;
    for (int i = 0; good && i < config_setting_length(group); i++) {
        config_setting_t *s = config_setting_get_elem(group, (unsigned)i);
        const char *name = config_setting_name(s);
        char *key = xasprintf("%s%s%s", prefix, *prefix ? "." : "", name);
        if (config_setting_is_group(s))
            good = walk_group(w, s, key);
        else if (config_setting_is_scalar(s) && strcmp(name, "name") != 0 && strcmp(name, "description") != 0)
            good = add(w, s, key);
        free(key);
    }
    return good;
}

/* set: settings KEY=VALUE, ended by NULL; or NULL. */
static bool walk_file(struct cfg_numbers *to, const char *path, const char *prefix, char *const *set,
                      char **error)
{
    struct cfg_reader r;
    bool good = cfg_open(&r, path);
    for (; good && set && *set; set++)
        good = cfg_set(&r, *set);
    good = good && walk_group(&(struct walk){&r, to}, r.root, prefix);
    cfg_close(&r);
    *error = r.error;
    return good;
}

struct cfg_numbers *cfg_numbers_read(const struct cfg_machine *m, char **error)
{
    struct cfg_numbers *n = xcalloc(1, sizeof *n);
    if (walk_file(n, m->path, "", m->set, error) && walk_file(n, m->cpu, "cpu", NULL, error))
        return n;
    cfg_numbers_free(n);
    return NULL;
}

const struct cfg_number *cfg_numbers_find(const struct cfg_numbers *n, const char *key)
{
    for (size_t i = 0; i < n->count; i++)
        if (!strcmp(n->list[i].key, key))
            return &n->list[i];
    return NULL;
}

void cfg_numbers_free(struct cfg_numbers *n)
{
    for (size_t i = 0; i < n->count; i++) {
        free(n->list[i].key);
        free(n->list[i].value);
        free(n->list[i].standing);
        free(n->list[i].source);
    }
    free(n->list);
    free(n);
}
