/* json_set.c - see json_set.h. */
#include "files/json_set.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "kernel/xalloc.h"

/* Not exit(), as in xexhausted(): its handlers must not run on a fiber or beside running threads. */
static void check(int result, const char *key)
{
    if (result == 0)
        return;
    dprintf(STDERR_FILENO, "touchstone: %s cannot be set: its text is not UTF-8, or memory is exhausted\n",
            key);
    _exit(EXIT_FAILURE);
}

void json_set(json_t *object, const char *key, json_t *value)
{
    check(json_object_set_new(object, key, value), key);
}

void json_append(json_t *list, json_t *value)
{
    check(json_array_append_new(list, value), "a list's element");
}

json_t *json_real_or_null(double x)
{
    return isfinite(x) ? json_real(x) : json_null();
}

json_t *json_ps(vtime_sum t)
{
    return t > INT64_MAX ? json_real((double)t) : json_integer((json_int_t)t);
}

json_t *json_string_or_null(const char *text)
{
    return text ? json_string(text) : json_null();
}

json_t *json_text(const char *text)
{
    json_t *string = json_string(text);
    if (string)
        return string;
    char *ascii = xstrdup(text);
    for (char *c = ascii; *c; c++)
        *c = *c & 0x80 ? '?' : *c;
    string = xchecked(json_string(ascii));
    free(ascii);
    return string;
}

json_t *json_texts(char *const list[])
{
    json_t *array = json_array();
    for (char *const *text = list; text && *text; text++)
        json_append(array, json_text(*text));
    return array;
}

char *json_keys_text(const json_t *object, const json_t *without)
{
    const char *key, *before = "";
    json_t *value;
    char *text;
    size_t size;
    FILE *f = xchecked(open_memstream(&text, &size));
    json_object_foreach((json_t *)object, key, value)
    {
        if (json_object_get(without, key))
            continue;
        fprintf(f, "%s%s", before, key);
        before = ", ";
    }
    fclose(f);
    return text;
}
