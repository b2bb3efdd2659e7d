/* chart_script.h - the gnuplot script of a picture.
 *
 * The script has a data block $lP_L for line L of panel P (x, y), and a block $mP_L for its markers (x, y,
 * size, pointtype); then the commands that draw the PNG, and those that draw the SVG.
 */
#ifndef LAB_CHART_CHART_SCRIPT_H
#define LAB_CHART_CHART_SCRIPT_H
#include "lab/chart/chart_data.h"

/* Writes the script that draws DIR/FILE.png and DIR/FILE.svg. header: of the results (record.h). False if the
 * data have no point. */
bool chart_script_write(const json_t *header, const struct picture *p, const struct chart_data *d,
                        const char *dir, FILE *script);
#endif
