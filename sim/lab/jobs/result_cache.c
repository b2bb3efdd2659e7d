/* result_cache.c - see result_cache.h. */
#include "lab/jobs/result_cache.h"
#include "files/atomic_file.h"
#include "files/folder_make.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/jobs/journal_line.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

char *result_cache_folder(void)
{
    const char *xdg = getenv("XDG_CACHE_HOME"), *home = getenv("HOME");
    if (xdg && *xdg == '/')
        return xasprintf("%s/touchstone", xdg);
    return home && *home == '/' ? xasprintf("%s/.cache/touchstone", home) : NULL;
}

/* The folder of a point's file. */
static char *folder_of(const char *folder, struct digest key)
{
    return xasprintf("%s/%.2s", folder, digest_text(key).text);
}

/* The file's bytes, malloc'd; NULL if the file cannot be read. */
static char *read_all(const char *path, size_t *size)
{
    struct stat st;
    FILE *in = fopen(path, "re");
    char *text = NULL;
    if (in && fstat(fileno(in), &st) == 0 && (text = malloc((size_t)st.st_size + 1)))
        *size = fread(text, 1, (size_t)st.st_size, in);
    if (in)
        fclose(in);
    return text;
}

static json_t *read_record(const char *text, size_t size, struct digest key)
{
    struct digest found;
    enum journal_line_state state;
    if (!size || text[size - 1] != '\n' || !journal_line_check(text, size - 1, &found, &state) ||
        !digest_equal(found, key))
        return NULL;
    return journal_line_record(text, size - 1);
}

json_t *result_cache_find(const char *folder, struct digest key, const json_t *inputs, FILE *notes)
{
    size_t size = 0;
    char *dir = folder_of(folder, key), *path = xasprintf("%s/%s", dir, digest_text(key).text),
         *text = read_all(path, &size);
    json_t *record = text ? read_record(text, size, key) : NULL;
    if (text && !record)
        fprintf(notes, "%s is damaged: its point is run again\n", path);
    if (record && !json_equal(json_object_get(record, "inputs"), inputs)) {
        json_decref(record);
        record = NULL;
    }
    if (record)
        json_object_del(record, "inputs");
    free(text);
    free(path);
    free(dir);
    return record;
}

bool result_cache_add(const char *folder, struct digest key, json_t *inputs, json_t *record, FILE *notes)
{
    char *error = NULL;
    size_t size;
    json_t *both = json_copy(record);
    json_set(both, "inputs", json_incref(inputs));
    char *line = journal_line_write(key, LINE_DONE, both, &size), *dir = folder_of(folder, key);
    char *path = xasprintf("%s/%s", dir, digest_text(key).text);
    bool added = folder_make(dir);
    if (!added)
        error = xasprintf("%s cannot be made: %m", dir);
    added = added && atomic_file_write(path, line, size, &error);
    if (!added)
        fprintf(notes, "not added to the result cache: %s\n", error);
    free(error);
    free(path);
    free(dir);
    free(line);
    json_decref(both);
    return added;
}
