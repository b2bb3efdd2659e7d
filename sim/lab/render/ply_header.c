/* ply_header.c - see ply_header.h. */
#include "lab/render/ply_header.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

enum { MOST_WORDS = 6, MOST_LINE = 1024 };

static const struct {
    const char *name, *other_name;
    size_t size;
} TYPES[] = {[PLY_INT8] = {"char", "int8", 1},      [PLY_UINT8] = {"uchar", "uint8", 1},
             [PLY_INT16] = {"short", "int16", 2},   [PLY_UINT16] = {"ushort", "uint16", 2},
             [PLY_INT32] = {"int", "int32", 4},     [PLY_UINT32] = {"uint", "uint32", 4},
             [PLY_FLOAT] = {"float", "float32", 4}, [PLY_DOUBLE] = {"double", "float64", 8}};

size_t ply_type_size(enum ply_type type)
{
    return TYPES[type].size;
}

/* A line cut into words. */
struct words {
    char text[MOST_LINE];
    const char *word[MOST_WORDS];
    int count; /* MOST_WORDS: that many or more */
};

static bool read_type(const char *word, enum ply_type *type, char **why)
{
    for (size_t i = 0; i < sizeof TYPES / sizeof *TYPES; i++)
        if (!strcmp(word, TYPES[i].name) || !strcmp(word, TYPES[i].other_name)) {
            *type = (enum ply_type)i;
            return true;
        }
    *why = xasprintf("'%s' is no type of PLY files (char, uchar, short, ushort, int, uint, float, double)",
                     word);
    return false;
}

static bool read_name(const char *word, char name[PLY_NAME_SIZE], char **why)
{
    if (strlen(word) < PLY_NAME_SIZE) {
        strcpy(name, word);
        return true;
    }
    *why = xasprintf("a name has more than %d letters", PLY_NAME_SIZE - 1);
    return false;
}

static bool read_format(struct ply_header *h, const struct words *w, char **why)
{
    static const char *const NAMES[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    for (size_t i = 0; i < sizeof NAMES / sizeof *NAMES && w->count == 3; i++)
        if (!strcmp(w->word[1], NAMES[i]) && !strcmp(w->word[2], "1.0")) {
            h->format = (enum ply_format)i;
            return true;
        }
    *why = xstrdup("this format is unknown (ascii, binary_little_endian or binary_big_endian, and 1.0)");
    return false;
}

static bool read_element(struct ply_header *h, const struct words *w, char **why)
{
    if (h->element_count == PLY_MOST_ELEMENTS) {
        *why = xasprintf("more than %d elements", PLY_MOST_ELEMENTS);
        return false;
    }
    struct ply_element *e = &h->element[h->element_count++];
    e->property_count = 0;
    char *end = NULL;
    errno = 0;
    if (w->count == 3 && *w->word[2] >= '0' && *w->word[2] <= '9')
        e->count = strtoull(w->word[2], &end, 10);
    if (!end || *end || errno) {
        *why = xstrdup("expected: element NAME COUNT");
        return false;
    }
    return read_name(w->word[1], e->name, why);
}

static bool read_property(struct ply_header *h, const struct words *w, char **why)
{
    if (!h->element_count) {
        *why = xstrdup("a property without an element before it");
        return false;
    }
    struct ply_element *e = &h->element[h->element_count - 1];
    if (e->property_count == PLY_MOST_PROPERTIES) {
        *why = xasprintf("more than %d properties of %s", PLY_MOST_PROPERTIES, e->name);
        return false;
    }
    struct ply_property *p = &e->property[e->property_count++];
    p->is_list = w->count == 5 && !strcmp(w->word[1], "list");
    if (!p->is_list && w->count != 3) {
        *why = xstrdup("expected: property TYPE NAME, or property list TYPE TYPE NAME");
        return false;
    }
    return (!p->is_list || read_type(w->word[2], &p->count_type, why)) &&
           read_type(w->word[w->count - 2], &p->type, why) && read_name(w->word[w->count - 1], p->name, why);
}

/* Takes the next line off the text. False: there is none, or it is too long for a head. */
static bool next_line(const char **text, const char *end, struct words *w)
{
    const char *stop = memchr(*text, '\n', (size_t)(end - *text));
    size_t length = stop ? (size_t)(stop - *text) : 0;
    if (!stop || length >= MOST_LINE || memchr(*text, 0, length))
        return false;
    memcpy(w->text, *text, length);
    w->text[length] = 0;
    w->count = 0;
    char *rest = w->text, *word;
    while (w->count < MOST_WORDS && (word = strsep(&rest, " \t\r")))
        if (*word)
            w->word[w->count++] = word;
    *text = stop + 1;
    return true;
}

/* Reads one line after the first. */
static bool read_line(struct ply_header *h, const struct words *w, char **why)
{
    const char *what = w->count ? w->word[0] : "";
    if (!*what || !strcmp(what, "comment") || !strcmp(what, "obj_info"))
        return true;
    if (!strcmp(what, "format"))
        return read_format(h, w, why);
    if (!strcmp(what, "element"))
        return read_element(h, w, why);
    if (!strcmp(what, "property"))
        return read_property(h, w, why);
    *why = xasprintf("'%.32s' begins no line of a PLY file's head", what);
    return false;
}

static bool is_word(const struct words *w, const char *word)
{
    return w->count == 1 && !strcmp(w->word[0], word);
}

static bool read_lines(const char **text, const char *end, struct ply_header *h, char **why)
{
    struct words w;
    bool has_format = false;
    for (h->lines = 1;; h->lines++) {
        if (!next_line(text, end, &w))
            *why = xstrdup(h->lines == 1 ? "this is no PLY file: its first line is not 'ply'"
                                         : "the head has no end: no line 'end_header'");
        else if (h->lines == 1 && !is_word(&w, "ply"))
            *why = xstrdup("this is no PLY file: its first line is not 'ply'");
        else if (is_word(&w, "end_header") && !has_format)
            *why = xstrdup("the head names no format");
        else if (is_word(&w, "end_header"))
            return true;
        else if (h->lines > 1)
            read_line(h, &w, why);
        if (*why)
            return false;
        has_format = has_format || (w.count && !strcmp(w.word[0], "format"));
    }
}

bool ply_header_read(const char *text, size_t size, struct ply_header *h, char **error)
{
    const char *at = text;
    char *why = NULL;
    h->element_count = 0;
    bool ok = read_lines(&at, text + size, h, &why);
    if (!ok)
        *error = xasprintf("%d: %s", h->lines, why);
    free(why);
    h->bytes = (size_t)(at - text);
    return ok;
}
