/* draw_read.h - what delays are drawn by, as text: the value of --timing. */
#ifndef TIMING_DRAW_READ_H
#define TIMING_DRAW_READ_H
#include "timing/draw.h"

/* Reads "SEED[,method=random|pct][,depth=D][,length=K][,messages=TIME][,interrupts=TIME][,speed=PERCENT%]
 * [,start=TIME]". Returns NULL, or what is wrong, malloc'd. */
char *draw_read(const char *text, struct draw *d);
/* All of it as draw_read() reads it; malloc'd. */
char *draw_text(const struct draw *d);
#endif
