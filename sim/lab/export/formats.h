/* formats.h - the writers of export.h, one a format. */
#ifndef LAB_EXPORT_FORMATS_H
#define LAB_EXPORT_FORMATS_H
#include <stdbool.h>
#include <stdio.h>
#include "lab/export/export.h"
#include "lab/export/timeline.h"

/* Shows a terminal how many nodes are done, if the work takes more than a second. */
struct export_progress {
    FILE *to; /* NULL: nowhere */
    double began;
};
void export_progress_show(struct export_progress *p, const struct trace *t, int32_t node);
void export_progress_end(struct export_progress *p);

/* Each writes a whole file; false with *error (malloc'd). Whether `out` failed, it says itself. */
typedef bool export_writer(const struct timeline *l, FILE *out, struct export_progress *p, char **error);
export_writer chrome_json_write, paje_write, picl_write;
void csv_table_write(const struct trace *t, enum export_table table, FILE *out);
/* Makes the folder, which must not be there. */
bool otf2_folder_write(const struct timeline *l, const char *folder, struct export_progress *p, char **error);
#endif
