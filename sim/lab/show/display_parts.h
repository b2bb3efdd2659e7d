/* display_parts.h - the displays' functions: see displays.h, whose table names them. A height may depend
 * on the number of rows. */
#ifndef LAB_SHOW_DISPLAY_PARTS_H
#define LAB_SHOW_DISPLAY_PARTS_H
#include "lab/draw/picture_head.h"

double utilisation_height(const struct show *s);
void utilisation_draw(const struct show *s, const struct canvas *c);
double gantt_height(const struct show *s);
void gantt_draw(const struct show *s, const struct canvas *c);
double space_time_height(const struct show *s);
void space_time_draw(const struct show *s, const struct canvas *c);
double matrix_height(const struct show *s);
void matrix_draw(const struct show *s, const struct canvas *c);
double lengths_height(const struct show *s);
void lengths_draw(const struct show *s, const struct canvas *c);
double queues_height(const struct show *s);
void queues_draw(const struct show *s, const struct canvas *c);
double channels_height(const struct show *s);
void channels_draw(const struct show *s, const struct canvas *c);
double kiviat_height(const struct show *s);
void kiviat_draw(const struct show *s, const struct canvas *c);
#endif
