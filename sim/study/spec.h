/* spec.h - a study file: a program, a machine, the axes along which runs differ, and the pictures to draw of them.
 *
 *     title = "...";  program = "app/model";  machine = "delta";  arguments = "-approx 111";
 *     axes = (
 *         { name = "nodes"; values = ( 16, 64 ); },
 *         { name = "group"; values = ( 2, 4, 8 ); arguments = "-group {}"; },
 *         { name = "disks"; values = ( 2, 8 ); set = ( "cfs.disks={}" ); },
 *         { name = "output"; cases = ( { label = "none"; }, { label = "all"; arguments = "-parts /cfs/p"; } ); } );
 *     only = ( "group <= nodes" );
 *     pictures = ( { file = "time"; x = "group"; y = "total_s"; lines = "output"; panels = "nodes"; } );
 *
 * A point is one value of each axis; it is run once. A value's text stands for {} in the axis's settings and
 * arguments; axes named nodes and machine are understood without. A case brings settings and arguments of its own.
 * Points for which a condition of `only` does not hold are left out.
 */
#ifndef STUDY_SPEC_H
#define STUDY_SPEC_H
#include "config/reader.h"

enum { SPEC_MAX_AXES = 8, SPEC_MAX_NODES = 1 << 20 };

struct spec_value {
    char *label;           /* "16", "none" */
    double number;         /* NAN if the label is none */
    config_setting_t *set; /* a list of texts KEY=VALUE, {} in them; or NULL */
    const char *arguments; /* words separated by blanks, {} in them; may be "" */
};

struct spec_axis {
    const char *name;
    struct spec_value *values;
    size_t count;
    bool numeric; /* all values are numbers */
};

/* A figure against an axis, or the value of an axis at which the figure is least. Axes are NULL where not given. */
struct spec_picture {
    const char *file;   /* FILE.png and FILE.svg */
    const char *title;  /* as the others below "" when not given */
    const char *figure; /* its key in the results */
    const char *x_label, *y_label;
    const struct spec_axis *x, *lines, *panels;
    const struct spec_axis *best; /* draw this axis's value where figure is least */
    bool log_x, log_y;
};

struct spec {
    struct cfg_reader reader; /* owns the texts */
    const char *title, *program, *machine, *arguments;
    uint64_t nodes; /* 0: an axis has them */
    struct spec_axis axes[SPEC_MAX_AXES];
    size_t axis_count;
    struct condition *only;
    size_t only_count;
    struct spec_picture *pictures;
    size_t picture_count;
};

/* Reads a study file. path must outlive the spec. NULL with *error a malloc'd text, file:line: key: what is wrong. */
struct spec *spec_read(const char *path, char **error);
void spec_free(struct spec *s);

/* The axis of that name, or NULL. */
const struct spec_axis *spec_axis(const struct spec *s, const char *name);
/* Its place in axes. */
size_t spec_place(const struct spec *s, const struct spec_axis *axis);
#endif
