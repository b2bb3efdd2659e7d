/* reader.c - checked reading of a libconfig file; see reader.h. */
#include "config/reader.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "files/text_file.h"
#include "kernel/xalloc.h"
#include "nx_api/contract/edit_distance.h"

enum { MAX_TEXT = 2048, MAX_KEY = 64 };

/* The path of the file that libconfig knows by that name: included files are relative to the folder of
 * r's own file, which has no name. Malloc'd. */
static char *path_of(const struct cfg_reader *r, const char *name)
{
    const char *slash = strrchr(r->path, '/');
    if (!name)
        return xstrdup(r->path);
    return *name == '/' || !slash ? xstrdup(name)
                                  : xasprintf("%.*s/%s", (int)(slash - r->path), r->path, name);
}

char *cfg_path_at(const struct cfg_reader *r, const config_setting_t *at)
{
    return path_of(r, at ? config_setting_source_file(at) : NULL);
}

bool cfg_fail(struct cfg_reader *r, config_setting_t *at, const char *key, const char *format, ...)
{
    if (r->error)
        return false;
    char text[MAX_TEXT], where[32] = "";
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);

    /* The root group has no line of its own; a value that did not come from the file has its setting's text.
     */
    const char *set = at ? config_setting_get_hook(at) : NULL;
    if (at && !set && config_setting_source_line(at) > 0)
        snprintf(where, sizeof where, ":%u", (unsigned)config_setting_source_line(at));
    char *file = set ? xstrdup(set) : cfg_path_at(r, at);
    r->error = xasprintf("%s%s: %s%s%s", file, where, key ? key : "", key ? ": " : "", text);
    free(file);
    return false;
}

/* No file that a person writes is as large. */
enum { MOST_BYTES = 4 << 20 };

/* A file that is being read, and the file that includes it; NULL: none. */
struct reading {
    const char *path;
    const struct reading *by;
    int line; /* of that file */
    int depth;
};

static char *read_all(struct cfg_reader *r, const struct reading *file);

static bool is_being_read(const struct reading *file, const char *path)
{
    for (; file; file = file->by)
        if (strcmp(file->path, path) == 0)
            return true;
    return false;
}

/* Checks the file that a line includes, if it includes one. libconfig reads the file later, and its errors
 * would not say what is wrong with the file. */
static bool check_include(struct cfg_reader *r, const struct reading *file, const char *line, int number)
{
    line += strspn(line, " \t");
    if (strncmp(line, "@include", 8) != 0 || !(line = strchr(line, '"')))
        return true;
    char *name = xstrndup(line + 1, strcspn(line + 1, "\"\n")), *included = path_of(r, name), *text = NULL;
    if (is_being_read(file, included))
        r->error =
            xasprintf("%s:%d: @include \"%s\": a file cannot include itself, nor a file that includes it",
                      file->path, number, name);
    else
        text = read_all(r, &(struct reading){included, file, number, file->depth + 1});
    bool good = text;
    free(text);
    free(included);
    free(name);
    return good;
}

/* Does a comment of several lines go on behind this line? Others end with it. */
static bool ends_in_comment(const char *line, bool in_comment)
{
    for (bool in_text = false; *line && *line != '\n'; line++)
        if (in_comment && !strncmp(line, "*/", 2))
            in_comment = false, line++;
        else if (in_comment)
            continue;
        else if (*line == '"')
            in_text = !in_text;
        else if (in_text)
            line += line[0] == '\\' && line[1] == '"';
        else if (!strncmp(line, "/*", 2))
            in_comment = true, line++;
        else if (*line == '#' || !strncmp(line, "//", 2))
            break;
    return in_comment;
}

/* The runs of a study read its machine file again, and what a pipe gave is gone; one that nobody writes into
 * would be waited for without end. */
static bool is_pipe(const char *path, const char **why, int *line)
{
    struct stat st;
    if (stat(path, &st) != 0 || !S_ISFIFO(st.st_mode))
        return false;
    *why = "it is a pipe, and may have to be read more than once: write its text into a file";
    *line = 0;
    return true;
}

/* "mine.cfg:7: @include: x/ipsc860.inc cannot be read: No such file or directory" */
static char *unreadable(const struct reading *file, int at, const char *why)
{
    if (at)
        return xasprintf("%s:%d: %s", file->path, at, why);
    if (!file->by)
        return xasprintf("%s: cannot be read: %s", file->path, why);
    return xasprintf("%s:%d: @include: %s cannot be read: %s (a path from this file's folder)",
                     file->by->path, file->line, file->path, why);
}

/* The text of a file, malloc'd. NULL with r's error set if the file, or one that it includes, is no text
 * file. */
static char *read_all(struct cfg_reader *r, const struct reading *file)
{
    enum { DEEPEST = 10 }; /* libconfig's own limit */
    const char *why;
    int at, number = 1;
    char *text = is_pipe(file->path, &why, &at) ? NULL : text_file_read(file->path, MOST_BYTES, &why, &at);
    if (!text)
        r->error = unreadable(file, at, why);
    bool in_comment = false;
    for (const char *line = text; file->depth < DEEPEST && line && *line; number++) {
        if (!in_comment && !check_include(r, file, line, number)) {
            free(text);
            return NULL;
        }
        in_comment = ends_in_comment(line, in_comment);
        line += strcspn(line, "\n"), line += *line == '\n';
    }
    return text;
}

/* The folder in which the files are that a file includes: its own. */
static char *folder_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? xstrndup(path, slash > path ? (size_t)(slash - path) : 1) : xstrdup(".");
}

static bool has_mark(const char *path)
{
    char begin[sizeof TEXT_BYTE_ORDER_MARK] = "";
    FILE *f = fopen(path, "r");
    if (!f)
        return false;
    bool read = fgets(begin, sizeof begin, f);
    fclose(f);
    return read && !strcmp(begin, TEXT_BYTE_ORDER_MARK);
}

/* What libconfig says of the file, or of one that it includes, whose byte order mark it has read, too. */
static char *syntax_error(const struct cfg_reader *r)
{
    char *file = path_of(r, config_error_file(&r->lib));
    int line = config_error_line(&r->lib);
    bool marked = line == 1 && config_error_file(&r->lib) && has_mark(file);
    char *text = marked ? xasprintf("%s:1: begins with a byte order mark: save it without one", file)
                        : xasprintf("%s:%d: %s (settings are written: key = value;)", file, line,
                                    config_error_text(&r->lib));
    free(file);
    return text;
}

bool cfg_open(struct cfg_reader *r, const char *path)
{
    *r = (struct cfg_reader){.path = path};
    config_init(&r->lib);
    char *text = read_all(r, &(struct reading){.path = path}), *folder = folder_of(path);
    if (text)
        config_set_include_dir(&r->lib, folder);
    free(folder);
    if (!text)
        return false;
    bool read = config_read_string(&r->lib, text) == CONFIG_TRUE;
    free(text);
    if (!read) {
        r->error = syntax_error(r);
        return false;
    }
    r->root = config_root_setting(&r->lib);
    return true;
}

void cfg_close(struct cfg_reader *r)
{
    config_destroy(&r->lib);
}

static config_setting_t *member(struct cfg_reader *r, config_setting_t *in, const char *key)
{
    config_setting_t *s = config_setting_get_member(in, key);
    if (!s)
        cfg_fail(r, in, key, "missing");
    return s;
}

bool cfg_group(struct cfg_reader *r, config_setting_t *in, const char *key, config_setting_t **out)
{
    config_setting_t *s = r->error ? NULL : member(r, in, key);
    if (!s)
        return false;
    *out = s;
    return config_setting_is_group(s) || cfg_fail(r, s, key, "must be a group: %s = { ... };", key);
}

bool cfg_list(struct cfg_reader *r, config_setting_t *in, const char *key, config_setting_t **out)
{
    config_setting_t *s = r->error ? NULL : member(r, in, key);
    if (!s)
        return false;
    *out = s;
    return config_setting_is_list(s) || cfg_fail(r, s, key, "must be a list: %s = ( ... );", key);
}

bool cfg_text(struct cfg_reader *r, config_setting_t *in, const char *key, const char **out)
{
    config_setting_t *s = r->error ? NULL : member(r, in, key);
    if (!s)
        return false;
    *out = config_setting_get_string(s);
    return (*out && **out) || cfg_fail(r, s, key, "must be text in double quotes, not empty");
}

bool cfg_whole(struct cfg_reader *r, config_setting_t *in, const char *key, uint64_t min, uint64_t max,
               uint64_t *out)
{
    config_setting_t *s = r->error ? NULL : member(r, in, key);
    if (!s)
        return false;
    int type = config_setting_type(s);
    if (type != CONFIG_TYPE_INT && type != CONFIG_TYPE_INT64)
        return cfg_fail(r, s, key, "must be a whole number from %lu to %lu", min, max);
    long long value = config_setting_get_int64(s);
    if (value < 0 || (uint64_t)value < min || (uint64_t)value > max)
        return cfg_fail(r, s, key, "%lld is out of range: %lu to %lu are allowed", value, min, max);
    *out = (uint64_t)value;
    return true;
}

bool cfg_number(struct cfg_reader *r, config_setting_t *in, const char *key, double min, double max,
                double *out)
{
    config_setting_t *s = r->error ? NULL : member(r, in, key);
    if (!s)
        return false;
    double value;
    switch (config_setting_type(s)) {
    case CONFIG_TYPE_FLOAT:
        value = config_setting_get_float(s);
        break;
    case CONFIG_TYPE_INT:
    case CONFIG_TYPE_INT64:
        value = (double)config_setting_get_int64(s);
        break;
    default:
        return cfg_fail(r, s, key, "must be a number from %g to %g", min, max);
    }
    if (!(value >= min && value <= max))
        return cfg_fail(r, s, key, "%g is out of range: %g to %g are allowed", value, min, max);
    *out = value;
    return true;
}

bool cfg_time(struct cfg_reader *r, config_setting_t *in, const char *key, const char *tail, uint64_t *ps)
{
    char us[MAX_KEY], ns[MAX_KEY];
    double value = 0; /* GCC does not see that cfg_number sets it */
    snprintf(us, sizeof us, "%s_us%s", key, tail);
    snprintf(ns, sizeof ns, "%s_ns%s", key, tail);
    if (r->error)
        return false;
    bool in_ns = config_setting_get_member(in, ns) != NULL;
    if (in_ns && config_setting_get_member(in, us))
        return cfg_fail(r, config_setting_get_member(in, ns), ns, "%s is given too: one of them only", us);
    double most_us = *tail ? 1e3 : 1e6; /* of a byte: no message takes longer than virtual time has */
    if (!cfg_number(r, in, in_ns ? ns : us, 0, in_ns ? 1e3 * most_us : most_us, &value))
        return false;
    *ps = (uint64_t)llround(value * (in_ns ? 1e3 : 1e6));
    return true;
}

const char *cfg_meant(const char *name, const char *const words[])
{
    struct edit_nearest n = {.meant = name};
    for (size_t k = 0; words[k]; k++)
        edit_see(&n, words[k]);
    return n.best;
}

bool cfg_only(struct cfg_reader *r, config_setting_t *in, const char *const keys[])
{
    if (r->error)
        return false;
    for (unsigned i = 0; i < (unsigned)config_setting_length(in); i++) {
        config_setting_t *s = config_setting_get_elem(in, i);
        size_t k = 0;
        while (keys[k] && strcmp(keys[k], config_setting_name(s)) != 0)
            k++;
        if (keys[k])
            continue;
        char allowed[MAX_TEXT / 2] = "";
        for (size_t used = k = 0; keys[k] && used < sizeof allowed; k++)
            used += (size_t)snprintf(allowed + used, sizeof allowed - used, "%s%s", k ? ", " : "", keys[k]);
        const char *name = config_setting_name(s), *meant = cfg_meant(name, keys);
        return cfg_fail(r, s, name, "unknown key; %s%s%snown here: %s", meant ? "did you mean " : "",
                        meant ? meant : "", meant ? "? K" : "k", allowed);
    }
    return true;
}
