/* slices.h - a host's window on the volume: grid data of the slices it needs now. */
#ifndef SLICES_H
#define SLICES_H
#include "layer.h"

/* Get ready to make grid data from slice `first` on. */
void slices_begin(const struct options *o, int first);

/* Read what is needed and make the grid data of slice k; ask for slices in rising order. Three are kept. */
void slices_prepare(int k);

/* After a group's last slice: read the one above it, the boundary where groups overlap, if that has not been
 * done. */
void slices_overlap(void);

/* The layer between slices k and k + 1, both prepared. */
struct layer slices_layer(int k);

#endif
