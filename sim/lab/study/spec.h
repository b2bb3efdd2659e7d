/* spec.h - a study file: a program, a machine, the axes along which runs differ, and the pictures to draw of them.
 *
 *     title = "...";  about = "what it asks";  program = "app/model";  machine = "delta";  arguments = "-approx 111";
 *     inputs = ( "volume.gz" );          # files that the program reads: a change of theirs is another study
 *     axes = (
 *         { name = "nodes"; values = { from = 16; to = 1024; times = 2; }; },
 *         { name = "group"; values = ( 2, 4, 8 ); arguments = "-group {}"; },
 *         { name = "disks"; values = ( 2, 8 ); set = ( "cfs.disks={}" ); },
 *         { name = "share"; value = "nodes / group"; arguments = "-share {}"; when = "share > 1"; },
 *         { name = "output"; cases = ( { label = "none"; }, { label = "all"; arguments = "-parts /cfs/p"; } ); } );
 *     only = ( "group <= nodes" );
 *     cost = "nodes";                    # how long a point takes, in any unit: the longest start first
 *     max_wall_s = 60.0;  max_virtual_s = 100.0;
 *     pictures = ( { file = "time"; x = "group"; y = "total_s"; lines = "output"; panels = "nodes"; } );
 *
 * A point is one value of each axis; it is run once. A value's text stands for {} in the axis's settings and
 * arguments; axes named nodes and machine are understood without. A case brings settings and arguments of its own. An
 * axis with `value` follows from those before it (expr.h). Points for which a condition of `only` does not hold are
 * left out. What is relative to a place is relative to the file's folder.
 *
 * Nothing here grows with the number of points: a range is kept as its ends, and points are told by their number.
 */
#ifndef LAB_STUDY_SPEC_H
#define LAB_STUDY_SPEC_H
#include "config/reader.h"
#include "lab/study/expr.h"
#include "lab/chart/picture.h"

enum { SPEC_MAX_AXES = 16, SPEC_MAX_NODES = 1 << 20, SPEC_MAX_POINTS = 100000000, SPEC_MAX_LABEL = 32 };

struct spec_value {
    char *label;           /* "16", "none" */
    double number;         /* NAN if the label is none */
    config_setting_t *set; /* a list of texts KEY=VALUE, {} in them; or NULL */
    const char *arguments; /* words separated by blanks, {} in them; may be "" */
};

enum spec_kind { SPEC_LIST, SPEC_RANGE, SPEC_DERIVED };

struct spec_axis {
    const char *name;
    enum spec_kind kind;
    size_t count;              /* of values; derived: 1, as it adds no points */
    bool numeric;              /* all values are numbers */
    struct spec_value *values; /* a list's; else one, whose label and number are not set */
    double from, step;         /* a range's, from + i * step or from * step^i */
    bool times;
    struct expr *value;   /* derived */
    struct expr *when;    /* its settings and arguments are only for points where this holds; NULL: for all */
    config_setting_t *at; /* where it is, for messages */
};

struct spec {
    struct cfg_reader reader; /* owns the texts */
    const char *path, *title, *about, *program, *machine, *arguments;
    uint64_t nodes; /* 0: an axis has them */
    struct spec_axis axes[SPEC_MAX_AXES];
    size_t axis_count;
    size_t product; /* values of all axes with all others: numbers of points are below it */
    struct expr **only;
    size_t only_count;
    struct expr *cost;                /* NULL: not given */
    const char **inputs;              /* files, ended by NULL */
    double max_wall_s, max_virtual_s; /* 0: none */
    bool profile;                     /* where the time of each point went, by function */
    struct picture *pictures;
    size_t picture_count;
};

/* Reads a study file. path must outlive the spec. NULL with *error a malloc'd text, file:line: key: what is wrong. */
struct spec *spec_read(const char *path, char **error);
void spec_free(struct spec *s);

/* The axis of that name, or NULL. */
const struct spec_axis *spec_axis(const struct spec *s, const char *name);
/* Its place in axes. */
size_t spec_place(const struct spec *s, const struct spec_axis *axis);

/* The i'th value of a list or range: its number (NAN if none), and its text in label or where the value is. */
double spec_value(const struct spec_axis *axis, size_t i, const char **text, char label[SPEC_MAX_LABEL]);
/* A number as a label: 4, 0.5. */
void spec_label(double number, char label[SPEC_MAX_LABEL]);

/* --- parts of the reading: spec_axes.c, spec_pictures.c --- */
bool spec_read_axes(struct cfg_reader *r, struct spec *s);
void spec_free_axes(struct spec *s);
bool spec_read_pictures(struct cfg_reader *r, struct spec *s);
/* An expression over the axes read so far, said to be under key at `at` if it is wrong; NULL. */
struct expr *spec_expression(struct cfg_reader *r, config_setting_t *at, const char *key, const char *text,
                             const struct spec *s);
/* The text of that key, or "" when it is not there. */
bool spec_optional(struct cfg_reader *r, config_setting_t *in, const char *key, const char **out);
/* Letters, digits, _ - . */
bool spec_is_name(const char *text);
void *spec_zeroed(size_t count, size_t size);
#endif
