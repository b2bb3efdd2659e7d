/* ply_file.c - see ply_file.h. */
#include "lab/render/ply_file.h"
#include <endian.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "lab/render/ply_header.h"

/* --- the whole file in memory --- */

/* A file that ends in a 0, which is not counted. NULL with errno. */
static char *read_all(FILE *in, size_t *size)
{
    size_t room = 1 << 20, got;
    char *text = xmalloc(room);
    *size = 0;
    while ((got = fread(text + *size, 1, room - *size - 1, in)) > 0) {
        *size += got;
        if (*size + 1 == room)
            text = xrealloc(text, room *= 2);
    }
    text[*size] = 0;
    if (!ferror(in))
        return text;
    free(text);
    return NULL;
}

static char *read_path(const char *path, size_t *size)
{
    FILE *in = strcmp(path, "-") ? fopen(path, "re") : stdin;
    if (!in)
        return NULL;
    char *text = read_all(in, size);
    int why = errno;
    if (in != stdin)
        fclose(in);
    errno = why;
    return text;
}

/* --- values, one after the other --- */

struct reader {
    const char *path;
    const char *begin, *at, *end;
    const struct ply_header *header;
    int line;              /* of an ascii file */
    const char *what;      /* what is read: "vertex" ... */
    uint64_t index, count; /* which of them, and of how many */
    char **error;
};

static bool fail(const struct reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Reports an error at the place that the reader has come to; returns false. */
static bool fail(const struct reader *r, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    char *why = xvasprintf(format, list);
    va_end(list);
    char *where = r->header->format == PLY_ASCII ? xasprintf("%s:%d", r->path, r->line)
                                                 : xasprintf("%s: byte %td", r->path, r->at - r->begin);
    *r->error =
        xasprintf("%s: %s %ju of %ju: %s", where, r->what, (uintmax_t)r->index + 1, (uintmax_t)r->count, why);
    free(where);
    free(why);
    return false;
}

/* The length of a word as an error shows it. */
static size_t word_length(const char *word)
{
    size_t length = strcspn(word, " \t\r\n");
    return length < 32 ? length : 32;
}

static bool next_ascii(struct reader *r, double *value)
{
    for (; r->at < r->end && strchr(" \t\r\n", *r->at); r->at++)
        r->line += *r->at == '\n';
    if (r->at == r->end)
        return fail(r, "the file ends here");
    char *stop;
    *value = strtod(r->at, &stop);
    if (stop == r->at || !strchr(" \t\r\n", *stop))
        return fail(r, "'%.*s' is no number", (int)word_length(r->at), r->at);
    r->at = stop;
    return true;
}

/* The bytes of a value as a number of that many bytes. */
static uint64_t bits_of(const char *at, size_t size, bool big)
{
    uint64_t bits = 0;
    for (size_t i = 0; i < size; i++)
        bits |= (uint64_t)(unsigned char)at[i] << 8 * (big ? size - 1 - i : i);
    return bits;
}

static double value_of(uint64_t bits, enum ply_type type)
{
    union {
        uint32_t bits;
        float value;
    } single = {(uint32_t)bits};
    union {
        uint64_t bits;
        double value;
    } twice = {bits};
    switch (type) {
    case PLY_INT8:
        return (int8_t)bits;
    case PLY_INT16:
        return (int16_t)bits;
    case PLY_INT32:
        return (int32_t)bits;
    case PLY_FLOAT:
        return single.value;
    case PLY_DOUBLE:
        return twice.value;
    default:
        return (double)bits;
    }
}

static bool next(struct reader *r, enum ply_type type, double *value)
{
    if (r->header->format == PLY_ASCII)
        return next_ascii(r, value);
    size_t size = ply_type_size(type);
    if ((size_t)(r->end - r->at) < size)
        return fail(r, "the file ends here");
    *value = value_of(bits_of(r->at, size, r->header->format == PLY_BIG_ENDIAN), type);
    r->at += size;
    return true;
}

/* Reads the length of a list, which the rest of the file can hold. */
static bool next_length(struct reader *r, const struct ply_property *p, uint32_t *length)
{
    double value;
    if (!next(r, p->count_type, &value))
        return false;
    size_t least = r->header->format == PLY_ASCII ? 1 : ply_type_size(p->type);
    if (!(value >= 0) || value != floor(value))
        return fail(r, "%g is no length of a list", value);
    if (value > (double)((size_t)(r->end - r->at) / least))
        return fail(r, "a list of %.0f values is longer than the rest of the file", value);
    *length = (uint32_t)value;
    return true;
}

static bool pass_over(struct reader *r, const struct ply_property *p)
{
    double value;
    uint32_t length = 1;
    if (p->is_list && !next_length(r, p, &length))
        return false;
    while (length-- > 0)
        if (!next(r, p->type, &value))
            return false;
    return true;
}

/* --- elements --- */

/* Begins an element. False: the file is too short for so many, or they are too many for a mesh. */
static bool begin(struct reader *r, const struct ply_element *e)
{
    size_t least = 0;
    for (size_t i = 0; i < e->property_count; i++) {
        const struct ply_property *p = &e->property[i];
        least += r->header->format == PLY_ASCII ? 2 : ply_type_size(p->is_list ? p->count_type : p->type);
    }
    r->what = e->name;
    r->index = 0;
    r->count = e->count;
    size_t left = (size_t)(r->end - r->at) + 1; /* the last line may lack its end */
    if (e->count > UINT32_MAX - 1 || (least && e->count > left / least)) {
        *r->error = xasprintf("%s: its head promises %ju of element %s, and the file is too short for them: "
                              "it was cut, or its head is wrong",
                              r->path, (uintmax_t)e->count, e->name);
        return false;
    }
    return true;
}

enum { PLACE = 0, NORMAL = 3, COLOUR = 6, VERTEX_VALUES = 9 };

/* Which value each property of a vertex is, -1: none; has: the values that are there. */
static void find_values(const struct ply_element *e, int value[PLY_MOST_PROPERTIES], bool has[VERTEX_VALUES])
{
    static const char *const NAMES[VERTEX_VALUES] = {"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue"};
    for (size_t i = 0; i < e->property_count; i++) {
        value[i] = -1;
        for (int k = 0; k < VERTEX_VALUES && !e->property[i].is_list; k++)
            if (!strcmp(e->property[i].name, NAMES[k])) {
                value[i] = k;
                has[k] = true;
            }
    }
}

static uint8_t colour_value(double value, enum ply_type type)
{
    if (type == PLY_FLOAT || type == PLY_DOUBLE)
        value *= 255;
    return (uint8_t)(value >= 255 ? 255 : value > 0 ? lround(value) : 0);
}

/* Stores a value of vertex number r->index. */
static bool store(const struct reader *r, struct mesh *m, int which, enum ply_type type, double value)
{
    if (which >= COLOUR && m->colour)
        m->colour[r->index][which - COLOUR] = colour_value(value, type);
    else if (which < COLOUR && !isfinite((float)value))
        return fail(r, "%s is not finite", which < NORMAL ? "a coordinate" : "a normal");
    else if (which < NORMAL)
        m->place[r->index][which - PLACE] = (float)value;
    else if (which < COLOUR && m->normal)
        m->normal[r->index][which - NORMAL] = (float)value;
    return true;
}

static bool read_vertex(struct reader *r, const struct ply_element *e, const int *which, struct mesh *m)
{
    for (size_t i = 0; i < e->property_count; i++) {
        double value;
        if (which[i] < 0) {
            if (!pass_over(r, &e->property[i]))
                return false;
        } else if (!next(r, e->property[i].type, &value) ||
                   !store(r, m, which[i], e->property[i].type, value)) {
            return false;
        }
    }
    return true;
}

static bool read_vertices(struct reader *r, const struct ply_element *e, struct mesh *m)
{
    int which[PLY_MOST_PROPERTIES];
    bool has[VERTEX_VALUES] = {false};
    find_values(e, which, has);
    if (!has[PLACE] || !has[PLACE + 1] || !has[PLACE + 2]) {
        *r->error = xasprintf("%s: its vertices lack a property x, y or z", r->path);
        return false;
    }
    if (!begin(r, e))
        return false;
    m->vertex_count = (uint32_t)e->count;
    m->place = xmalloc(e->count * sizeof *m->place);
    if (has[NORMAL] && has[NORMAL + 1] && has[NORMAL + 2])
        m->normal = xmalloc(e->count * sizeof *m->normal);
    if (has[COLOUR] && has[COLOUR + 1] && has[COLOUR + 2])
        m->colour = xmalloc(e->count * sizeof *m->colour);
    for (; r->index < e->count; r->index++)
        if (!read_vertex(r, e, which, m))
            return false;
    return true;
}

static bool is_corners(const struct ply_property *p)
{
    return p->is_list && (!strcmp(p->name, "vertex_indices") || !strcmp(p->name, "vertex_index"));
}

/* Makes room for the corners of one more face; room: what there is. */
static void grow(struct mesh *m, uint32_t needed, uint32_t *room)
{
    if (needed <= *room)
        return;
    *room = needed < UINT32_MAX / 2 ? needed * 2 : UINT32_MAX;
    m->corner = xreallocarray(m->corner, *room, sizeof *m->corner);
}

static bool read_corners(struct reader *r, const struct ply_property *p, struct mesh *m, uint32_t *room)
{
    uint32_t length = 0, *next_first = m->first + r->index;
    if (!next_length(r, p, &length))
        return false;
    if (length < 3)
        return fail(r, "%u corner%s, and a polygon has at least 3", length, length == 1 ? "" : "s");
    if (length > UINT32_MAX - next_first[0])
        return fail(r, "more corners than 32 bits can count");
    next_first[1] = next_first[0] + length;
    grow(m, next_first[1], room);
    for (uint32_t i = next_first[0]; i < next_first[1]; i++) {
        double value;
        if (!next(r, p->type, &value))
            return false;
        if (!(value >= 0) || value >= m->vertex_count || value != floor(value))
            return fail(r, "there is no vertex %.0f: they are 0 to %.0f", value, (double)m->vertex_count - 1);
        m->corner[i] = (uint32_t)value;
    }
    return true;
}

static bool read_node(struct reader *r, const struct ply_property *p, struct mesh *m)
{
    double value;
    if (!next(r, p->type, &value))
        return false;
    if (!(value >= 0) || value > UINT32_MAX || value != floor(value))
        return fail(r, "%g is no number of a node", value);
    m->node[r->index] = (uint32_t)value;
    return true;
}

static bool is_node(const struct ply_property *p)
{
    return !p->is_list && !strcmp(p->name, "node");
}

static bool read_face(struct reader *r, const struct ply_element *e, struct mesh *m, uint32_t *room)
{
    for (size_t i = 0; i < e->property_count; i++) {
        const struct ply_property *p = &e->property[i];
        if (is_corners(p) ? !read_corners(r, p, m, room)
            : is_node(p)  ? !read_node(r, p, m)
                          : !pass_over(r, p))
            return false;
    }
    return true;
}

static bool read_faces(struct reader *r, const struct ply_element *e, struct mesh *m)
{
    uint32_t room = 0;
    size_t lists = 0, nodes = 0;
    for (size_t i = 0; i < e->property_count; i++) {
        lists += is_corners(&e->property[i]);
        nodes += is_node(&e->property[i]);
    }
    if (lists != 1 || nodes > 1) {
        *r->error = xasprintf("%s: its faces have %zu properties 'list ... vertex_indices', and %zu 'node'",
                              r->path, lists, nodes);
        return false;
    }
    if (!begin(r, e))
        return false;
    m->face_count = (uint32_t)e->count;
    m->first = xmalloc((e->count + 1) * sizeof *m->first);
    m->first[0] = 0;
    m->node = nodes ? xmalloc(e->count * sizeof *m->node) : NULL;
    grow(m, (uint32_t)(e->count < UINT32_MAX / 8 ? e->count * 2 : e->count), &room);
    for (; r->index < e->count; r->index++)
        if (!read_face(r, e, m, &room))
            return false;
    return true;
}

static bool pass_over_element(struct reader *r, const struct ply_element *e)
{
    if (!begin(r, e))
        return false;
    for (; r->index < e->count && e->property_count; r->index++)
        for (size_t i = 0; i < e->property_count; i++)
            if (!pass_over(r, &e->property[i]))
                return false;
    return true;
}

static const struct ply_element *element_named(const struct ply_header *h, const char *name)
{
    for (size_t i = 0; i < h->element_count; i++)
        if (!strcmp(h->element[i].name, name))
            return &h->element[i];
    return NULL;
}

static bool read_elements(struct reader *r, struct mesh *m)
{
    const struct ply_header *h = r->header;
    const struct ply_element *vertex = element_named(h, "vertex"), *face = element_named(h, "face");
    if (!vertex || !face || face < vertex) {
        *r->error = xasprintf("%s: its head names no element vertex, and after it an element face", r->path);
        return false;
    }
    for (const struct ply_element *e = h->element; e < h->element + h->element_count; e++)
        if (e == vertex ? !read_vertices(r, e, m)
            : e == face ? !read_faces(r, e, m)
                        : !pass_over_element(r, e))
            return false;
    return true;
}

bool ply_file_read(const char *path, struct mesh *mesh, char **error)
{
    const char *name = strcmp(path, "-") ? path : "standard input";
    size_t size;
    char *text = read_path(path, &size), *why = NULL;
    *mesh = (struct mesh){0};
    if (!text) {
        *error = xasprintf("%s cannot be read: %s", name, strerror(errno));
        return false;
    }
    struct ply_header *header = xmalloc(sizeof *header);
    bool ok = ply_header_read(text, size, header, &why);
    if (!ok)
        *error = xasprintf("%s:%s", name, why);
    struct reader r = {.path = name,
                       .begin = text,
                       .at = text + header->bytes,
                       .end = text + size,
                       .header = header,
                       .line = header->lines + 1,
                       .error = error};
    ok = ok && read_elements(&r, mesh);
    if (ok)
        mesh_triangulate(mesh);
    else
        mesh_free(mesh);
    free(why);
    free(header);
    free(text);
    return ok;
}
