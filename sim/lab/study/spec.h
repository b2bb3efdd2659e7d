/* spec.h - a study file: a program, a machine, the axes along which runs differ, and the pictures to draw.
 *
 *     title = "...";  about = "what it asks";  program = "app/model";  machine = "delta";
 *     arguments = "-approx 111";
 *     inputs = ( "volume.gz" );          # files that the program reads: results depend on their bytes
 *     axes = (
 *         { name = "nodes"; values = { from = 16; to = 1024; times = 2; }; },
 *         { name = "group"; values = ( 2, 4, 8 ); arguments = "-group {}"; },
 *         { name = "disks"; values = ( 2, 8 ); set = ( "cfs.disks={}", "cfs.io_nodes={}" ); },
 *         { name = "share"; value = "nodes / group"; arguments = "-share {}"; when = "share > 1"; },
 *         { name = "output"; cases = ( { label = "none"; },
 *                                     { label = "all"; arguments = "-parts /cfs/p"; } ); } );
 *     only = ( "group <= nodes" );
 *     cost = "nodes";                    # how long a point takes, in any unit; the longest start first
 *     baseline = ( "group=8" );          # of speed-ups (lab/chart/speedup.h)
 *     max_wall_s = 60.0;  max_virtual_s = 100.0;  max_unreceived_mb = 256;
 *     pictures = ( { file = "time"; x = "group"; y = "total_s"; lines = "output"; panels = "nodes";
 *                    ranges = "own"; },
 *                  { file = "gain"; x = "group"; y = "total_s"; ratio = "output"; panels = "nodes"; } );
 *
 * A point has one value on each axis and is run once. The value's text replaces {} in the axis's settings and
 * arguments; axes named nodes and machine need neither. A case has settings and arguments of its own. An axis
 * with `value` is derived from axes before it (expr.h). Points for which a condition of `only` does not hold
 * are left out. Paths are relative to the study file's folder.
 *
 * Memory does not grow with the number of points: a range is stored as its ends, a point is a number
 * (points.h).
 */
#ifndef LAB_STUDY_SPEC_H
#define LAB_STUDY_SPEC_H
#include "config/reader.h"
#include "lab/study/expr.h"
#include "lab/chart/picture.h"

enum { SPEC_MAX_AXES = 16, SPEC_MAX_NODES = 1 << 20, SPEC_MAX_POINTS = 100000000, SPEC_MAX_LABEL = 32 };

struct spec_value {
    char *label;           /* "16", "none" */
    double number;         /* NAN if the label is not a number */
    config_setting_t *set; /* a list of texts KEY=VALUE that may contain {}; or NULL */
    const char *arguments; /* words separated by blanks that may contain {}; may be "" */
};

enum spec_kind { SPEC_LIST, SPEC_RANGE, SPEC_DERIVED };

struct spec_axis {
    const char *name;
    enum spec_kind kind;
    size_t count;              /* of values; 1 for a derived axis, which adds no points */
    bool numeric;              /* all values are numbers */
    struct spec_value *values; /* of a list; otherwise one, whose label and number are not set */
    double from, step;         /* of a range: from + i * step, or from * step^i if `times` */
    bool times;
    struct expr *value;   /* of a derived axis */
    struct expr *when;    /* settings and arguments apply where this holds; NULL: to all points */
    config_setting_t *at; /* where the axis is defined, for messages */
};

struct spec {
    struct cfg_reader reader; /* owns the texts of the file */
    const char *path, *title, *about, *program, *machine, *arguments;
    uint64_t nodes; /* 0: there is an axis nodes */
    struct spec_axis axes[SPEC_MAX_AXES];
    size_t axis_count;
    size_t product; /* of all axes' counts: points are numbered from 0 to product - 1 */
    struct expr **only;
    size_t only_count;
    struct expr *cost;                /* NULL if not given */
    const char **inputs;              /* files, ended by NULL */
    const char **baseline;            /* texts AXIS=VALUE or AXIS, ended by NULL; NULL if not given */
    double max_wall_s, max_virtual_s; /* limits of each run; 0: none */
    uint64_t max_unreceived_mb;       /* as run --max-unreceived; 0: the usual */
    bool profile;                     /* each run has a profile by function */
    struct picture *pictures;
    size_t picture_count;
};

/* The axis of that name, or NULL. */
const struct spec_axis *spec_axis(const struct spec *s, const char *name);

/* "there is no axis nods; there are: nodes, group", malloc'd. */
char *spec_no_axis(const struct spec *s, const char *name);
/* The axis's index in s->axes. */
size_t spec_axis_index(const struct spec *s, const struct spec_axis *axis);

/* The i'th value of a list or range: returns its number (NAN if none) and sets *text, which lies in label or
 * in the axis. */
double spec_value(const struct spec_axis *axis, size_t i, const char **text, char label[SPEC_MAX_LABEL]);
/* Writes a number as a label: 4, 0.5. */
void spec_label(double number, char label[SPEC_MAX_LABEL]);

/* --- for reading the file: spec_read.c, spec_axes.c, spec_pictures.c --- */

/* Reads an expression over the axes read so far. NULL with an error about key at `at`. */
struct expr *spec_expression(struct cfg_reader *r, config_setting_t *at, const char *key, const char *text,
                             const struct spec *s);
/* Sets *out to the text of that key, "" if the key is missing. */
bool spec_optional(struct cfg_reader *r, config_setting_t *in, const char *key, const char **out);
/* Is text a name: letters, digits, _ - . ? */
bool spec_is_name(const char *text);
#endif
