/* channel_film.h - the use of channels as a film: an animated WebP, each picture an interval of time. */
#ifndef LAB_SHOW_CHANNEL_FILM_H
#define LAB_SHOW_CHANNEL_FILM_H
#include "lab/draw/picture_head.h"

/* Writes s->frames pictures of equal intervals, and calls tell(done, of) after each. False with *error,
 * malloc'd. */
typedef void film_tell(uint32_t done, uint32_t of);
bool channel_film_write(const struct show *s, const char *path, film_tell *tell, char **error);
#endif
