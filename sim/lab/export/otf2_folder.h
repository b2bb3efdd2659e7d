/* otf2_folder.h - a trace in Open Trace Format 2. */
#ifndef LAB_EXPORT_OTF2_FOLDER_H
#define LAB_EXPORT_OTF2_FOLDER_H
#include <stdbool.h>
#include "lab/export/export_progress.h"
#include "lab/export/timeline.h"

/* Makes the folder, which must not be there. False with *error (malloc'd): nothing was left behind. */
bool otf2_folder_write(const struct timeline *l, const char *folder, const struct export_progress *p,
                       char **error);
#endif
