/* slices.h - a host's window on the volume: grid data of the slices of its open layer and the next. */
#ifndef SLICES_H
#define SLICES_H
#include "layer.h"

/* Get ready to make grid data from slice `first` on. */
void slices_begin(const struct options *o, int first);

/* Make the grid data of slice k, and read the slices that it takes. Slices are to be prepared in rising
 * order; the last three stay valid. */
void slices_prepare(int k);

/* After a group's last slice: read the slice above, where groups overlap, unless it has been read. */
void slices_overlap(void);

/* The layer between slices k and k + 1, both prepared. */
struct layer slices_layer(int k);

/* Give all memory back, and close the volume. */
void slices_end(void);

#endif
