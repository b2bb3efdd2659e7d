/* options.c - reads the command line into struct options. */
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "c3.h"
#include "options.h"
#include "slice.h"

/* Isovalues are moved up by this much, so that F equals no isovalue at a lattice point, and no polygon
 * shrinks to a point. Gray levels are whole numbers, and doubled differences of gray levels, too. A
 * lattice of 2 cubes a side multiplies them by multiples of 1/8 along each axis: F is a multiple of
 * 1/4096. With 3 cubes these are multiples of 1/27, and with 4 of 1/64: F is a multiple of 1/2^21. */
#define OFF_LATTICE (9.5 / 4096)
#define OFF_LATTICE_OF_4 (OFF_LATTICE + 1.0 / (1 << 22))

struct parser {
    int argc, at;
    char **argv;
    const char *name; /* of the option being read */
    char *error;
    int size;
    int approx, x, y, z, step;
    double zspace;
};

static int complain(struct parser *p, const char *what)
{
    snprintf(p->error, p->size, "%s: %s", p->name, what);
    return -1;
}

static const char *argument(struct parser *p)
{
    return p->at + 1 < p->argc ? p->argv[++p->at] : NULL;
}

static int read_int(struct parser *p, int *value, int least)
{
    const char *text = argument(p);
    char *end;
    long v;

    if (!text)
        return complain(p, "needs a number after it");
    v = strtol(text, &end, 10);
    if (end == text || *end || v < least || v > 1000000000) {
        snprintf(p->error, p->size, "%s: '%s' is not a whole number from %d up", p->name, text, least);
        return -1;
    }
    *value = (int)v;
    return 0;
}

static int read_positive(struct parser *p, double *value)
{
    const char *text = argument(p);
    char *end;

    if (!text)
        return complain(p, "needs a number after it");
    *value = strtod(text, &end);
    if (end == text || *end || !(*value > 0) || isinf(*value)) {
        snprintf(p->error, p->size, "%s: '%s' is not a number above 0", p->name, text);
        return -1;
    }
    return 0;
}

/* One of `words`, which blanks separate; *value becomes its number, from 0 on. */
static int read_word(struct parser *p, int *value, const char *words)
{
    const char *text = argument(p), *w = words;
    size_t n;

    for (*value = 0; text && *w; ++*value) {
        n = strcspn(w, " ");
        if (strlen(text) == n && strncmp(text, w, n) == 0)
            return 0;
        w += n + (w[n] == ' ');
    }
    snprintf(p->error, p->size, "%s: needs one of these words after it: %s", p->name, words);
    return -1;
}

static int read_name(struct parser *p, const char **name)
{
    *name = argument(p);
    return *name ? 0 : complain(p, "needs a name after it");
}

static int read_isovalues(struct parser *p, struct isovalues *iso)
{
    const char *text = argument(p);
    char *end;

    if (!text)
        return complain(p, "needs gray levels after it, separated by commas");
    for (iso->n = 0;; text = end + 1) {
        if (iso->n == ISOVALUES_MAX)
            return complain(p, "too many isovalues (16 at most)");
        iso->value[iso->n] = strtod(text, &end);
        if (end == text || (*end && *end != ',') || !isfinite(iso->value[iso->n++]))
            return complain(p, "needs gray levels after it, separated by commas, such as 64,128");
        if (!*end)
            return 0;
    }
}

static int read_size(struct parser *p)
{
    return read_int(p, &p->x, 2) || read_int(p, &p->y, 2) || read_int(p, &p->z, 2) ? -1 : 0;
}

static int read_volume_option(struct parser *p, struct options *o, const char *name)
{
    int word;

    if (!strcmp(name, "-sphere")) {
        o->volume = NULL;
        return read_size(p);
    }
    if (!strcmp(name, "-volume")) {
        if (read_name(p, &o->volume) || read_size(p) || read_word(p, &word, "8 16"))
            return -1;
        o->bits = word == 0 ? 8 : 16;
        return 0;
    }
    if (!strcmp(name, "-approx")) {
        if (read_word(p, &word, "111 333"))
            return -1;
        p->approx = word == 0 ? 111 : 333;
        return 0;
    }
    if (!strcmp(name, "-isovalues"))
        return read_isovalues(p, &o->iso);
    if (!strcmp(name, "-grid"))
        return read_int(p, &p->step, 1);
    if (!strcmp(name, "-zspace"))
        return read_positive(p, &p->zspace);
    if (!strcmp(name, "-lattice")) {
        if (read_int(p, &o->lattice, 1))
            return -1;
        return o->lattice <= LATTICE_MAX ? 0 : complain(p, "the lattice has at most 4 small cubes a side");
    }
    if (!strcmp(name, "-search"))
        return read_int(p, &o->search, 1);
    if (!strcmp(name, "-outermost"))
        return read_positive(p, &o->outermost);
    if (!strcmp(name, "-ply"))
        return read_name(p, &o->ply);
    if (!strcmp(name, "-parts")) {
        o->parts_only = 1;
        return read_name(p, &o->ply);
    }
    if (!strcmp(name, "-digest")) {
        o->each |= EACH_HASHED;
        return 0;
    }
    if (!strcmp(name, "-bynode")) {
        o->each |= EACH_MARKED;
        return 0;
    }
    if (!strcmp(name, "-times")) {
        o->times = 1;
        return 0;
    }
    return 1;
}

static int read_policy_option(struct parser *p, struct policy *q, const char *name)
{
    int word;

    if (!strcmp(name, "-group"))
        return read_int(p, &q->group, 0);
    if (!strcmp(name, "-noreassign"))
        return q->reassign = 0;
    if (!strcmp(name, "-nooverlap"))
        return q->overlap = 0;
    if (!strcmp(name, "-noempty"))
        return q->empty = 0;
    if (!strcmp(name, "-preload"))
        return q->preload = 1, 0;
    if (!strcmp(name, "-keep"))
        return read_int(p, &q->keep, 0);
    if (!strcmp(name, "-gran"))
        return read_int(p, &q->gran, 1);
    if (!strcmp(name, "-lead"))
        return read_int(p, &q->lead, 0);
    if (!strcmp(name, "-minrows"))
        return read_int(p, &q->min_rows, 1);
    if (!strcmp(name, "-buffer"))
        return read_int(p, &q->buffer, 512);
    if (!strcmp(name, "-buffers"))
        return read_int(p, &q->buffers, 1);
    if (!strcmp(name, "-k"))
        return read_positive(p, &q->k);
    if (!strcmp(name, "-half"))
        return read_positive(p, &q->half);
    if (!strcmp(name, "-flush")) {
        if (read_word(p, &word, "wait chunk full"))
            return -1;
        q->flush = (enum flush)word;
        return 0;
    }
    if (!strcmp(name, "-weights")) {
        if (read_word(p, &word, "slices exact"))
            return -1;
        q->weights = (enum weights)word;
        return 0;
    }
    if (!strcmp(name, "-shares")) {
        if (read_word(p, &word, "slices layers"))
            return -1;
        q->shares = (enum shares)word;
        return 0;
    }
    if (!strcmp(name, "-prepare")) {
        if (read_word(p, &word, "chunk subcube once"))
            return -1;
        q->prepare = (enum prepare)word;
        return 0;
    }
    return 1;
}

static void set_defaults(struct options *o)
{
    static const struct policy usual = {.overlap = 1,
                                        .reassign = 1,
                                        .empty = 1,
                                        .keep = 1,
                                        .gran = 1,
                                        .lead = 12,
                                        .min_rows = 1,
                                        .buffer = 32768,
                                        .buffers = 2,
                                        .k = 2,
                                        .half = 0.5};

    memset(o, 0, sizeof *o);
    o->policy = usual;
    o->lattice = 2;
    o->search = 8;
    o->outermost = 11.0 / 12.0;
}

/* Subcubes, pixels and grid data of a slice are counted by ints. */
static int slice_fits(int x, int y)
{
    return (double)(x + 1.0) * (y + 1.0) * C3_COMPS <= INT_MAX;
}

/* Sets what depends on several options. */
static int complete(struct parser *p, struct options *o)
{
    int cubic = p->approx == 333, i, shorter;
    double top = o->bits == 8 ? 256 : 65536;

    if (p->x == 0) {
        p->x = cubic ? 192 : 512;
        p->y = cubic ? 128 : 512;
        p->z = 65;
    }
    if (!slice_fits(p->x, p->y)) {
        snprintf(p->error, p->size, "slices of %d x %d pixels are too large", p->x, p->y);
        return -1;
    }
    if (o->each & EACH_MARKED && !o->ply) {
        snprintf(p->error, p->size, "-bynode marks polygons in files: it needs -ply or -parts");
        return -1;
    }
    shorter = p->x < p->y ? p->x : p->y;
    if (p->zspace == 0)
        p->zspace = o->volume ? 1.0 : (double)shorter / (p->z - 1);
    grid_set(&o->grid, p->x, p->y, p->z, p->step, cubic ? C3_COMPS : 1, p->zspace);
    if (o->iso.n == 0)
        for (o->iso.n = 7, i = 0; i < 7; i++)
            o->iso.value[i] = o->volume ? (i + 1) * top / 8
                                        : slice_level(&o->grid, (i + 1) * o->outermost / 7 * shorter / 2);
    for (i = 0; i < o->iso.n; i++) {
        o->asked[i] = o->iso.value[i];
        o->iso.value[i] += cubic && o->lattice == 4 ? OFF_LATTICE_OF_4 : OFF_LATTICE;
    }
    return 0;
}

int options_read(struct options *o, int argc, char **argv, char *error, int size)
{
    struct parser p = {.argc = argc, .argv = argv, .error = error, .size = size, .approx = 111, .step = 4};
    int r;

    set_defaults(o);
    for (p.at = 1; p.at < argc; p.at++) {
        p.name = argv[p.at];
        if (!strcmp(p.name, "-help") || !strcmp(p.name, "--help") || !strcmp(p.name, "-h"))
            return 1;
        r = read_volume_option(&p, o, p.name);
        if (r > 0)
            r = read_policy_option(&p, &o->policy, p.name);
        if (r > 0)
            r = complain(&p, "no such option; -help lists them");
        if (r)
            return r;
    }
    return complete(&p, o);
}
